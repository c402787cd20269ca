#include "accel/wide/simd_fours.h"
#include "accel/wide/simd_pair.h"
#include "accel/wide/traverse.h"

namespace accel::wide {

extern const Kernel baselineKernel;
#ifdef __x86_64__
const Kernel baselineKernel = Traversal<Pair<Pair<Fours>>>::kernel("x86-64-v2");
#else
const Kernel baselineKernel = Traversal<Pair<Pair<Fours>>>::kernel("baseline");
#endif

}
