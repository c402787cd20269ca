#ifdef __x86_64__
#include "accel/wide/simd_sixteens.h"
#include "accel/wide/traverse.h"

namespace accel::wide {

extern const Kernel avx512Kernel;
const Kernel avx512Kernel = Traversal<Sixteens>::kernel("x86-64-v4");

}
#endif
