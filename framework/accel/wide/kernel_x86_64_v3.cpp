#include "accel/wide/simd_avx2.h"
#include "accel/wide/traverse.h"

namespace accel::wide {

extern const Kernel kernel_v3;
const Kernel kernel_v3 = Traversal<Avx2>::kernel("x86-64-v3");

}
