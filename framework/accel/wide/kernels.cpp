#include "accel/wide/kernels.h"
#include <array>
#include <vector>

namespace accel::wide {

extern const Kernel kernel_v2, kernel_v3, kernel_v4;

namespace {

    std::vector<const Kernel*> findKernels()
    {
        std::vector<const Kernel*> kernels;
        __builtin_cpu_init();
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw")
            && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq")
            && __builtin_cpu_supports("avx512vl"))
            kernels.push_back(&kernel_v4);
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi")
            && __builtin_cpu_supports("bmi2"))
            kernels.push_back(&kernel_v3);
        kernels.push_back(&kernel_v2);
        return kernels;
    }

}

std::span<const Kernel* const> kernels()
{
    static const std::vector<const Kernel*> kernels = findKernels();
    return kernels;
}

}
