#ifdef __x86_64__
#include "accel/wide/kernel.h"
#include "accel/wide/simd_eights.h"
#include "accel/wide/simd_pair.h"

namespace accel::wide {

extern const Kernel avx2Kernel;
const Kernel avx2Kernel = kernelOf<Pair<Eights>>("x86-64-v3");

}
#endif
