#ifdef __x86_64__
#include "accel/wide/simd_eights.h"
#include "accel/wide/simd_pair.h"
#include "accel/wide/traverse.h"

namespace accel::wide {

extern const Kernel avx2Kernel;
const Kernel avx2Kernel = Traversal<Pair<Eights>>::kernel("x86-64-v3");

}
#endif
