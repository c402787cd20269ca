#ifdef __x86_64__
#include "accel/wide/kernel.h"
#include "accel/wide/simd_sixteens.h"

namespace accel::wide {

extern const Kernel avx512Kernel;
const Kernel avx512Kernel = kernelOf<Sixteens>("x86-64-v4");

}
#endif
