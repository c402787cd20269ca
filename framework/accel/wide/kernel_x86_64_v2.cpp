#include "accel/wide/simd_halves.h"
#include "accel/wide/traverse.h"

namespace accel::wide {

extern const Kernel kernel_v2;
const Kernel kernel_v2 = Traversal<Halves4>::kernel("x86-64-v2");

}
