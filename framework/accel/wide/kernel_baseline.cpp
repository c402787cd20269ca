#include "accel/wide/kernel.h"
#include "accel/wide/simd_fours.h"
#include "accel/wide/simd_pair.h"

namespace accel::wide {

extern const Kernel baselineKernel;
#ifdef __x86_64__
const Kernel baselineKernel = kernelOf<Pair<Pair<Fours>>>("x86-64-v2");
#else
const Kernel baselineKernel = kernelOf<Pair<Pair<Fours>>>("baseline");
#endif

}
