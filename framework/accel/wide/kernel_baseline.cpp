#include "accel/wide/simd_halves.h"
#include "accel/wide/traverse.h"

namespace accel::wide {

extern const Kernel baselineKernel;
#ifdef __x86_64__
const Kernel baselineKernel = Traversal<Halves4>::kernel("x86-64-v2");
#else
const Kernel baselineKernel = Traversal<Halves4>::kernel("baseline");
#endif

}
