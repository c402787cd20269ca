#include "accel/wide/kernels.h"
#include <vector>

namespace accel::wide {

extern const Kernel baselineKernel, avx2Kernel, avx512Kernel;

namespace {

    std::vector<const Kernel*> findKernels()
    {
        std::vector<const Kernel*> kernels;
#ifdef __x86_64__
        __builtin_cpu_init();
        const bool hasV3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")
            && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
        const bool hasV4 = hasV3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw")
            && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq")
            && __builtin_cpu_supports("avx512vl");
        if (hasV4)
            kernels.push_back(&avx512Kernel);
        if (hasV3)
            kernels.push_back(&avx2Kernel);
#endif
        kernels.push_back(&baselineKernel);
        return kernels;
    }

}

std::span<const Kernel* const> kernels()
{
    static const std::vector<const Kernel*> kernels = findKernels();
    return kernels;
}

}
