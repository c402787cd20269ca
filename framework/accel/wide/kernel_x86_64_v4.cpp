#include "accel/wide/simd_avx512.h"
#include "accel/wide/traverse.h"

namespace accel::wide {

extern const Kernel kernel_v4;
const Kernel kernel_v4 = Traversal<Avx512>::kernel("x86-64-v4");

}
