#include "values/resident_memory.h"
#include <algorithm>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace values {

std::size_t residentMemory()
{
    std::ifstream file("/proc/self/statm"); // in pages: all of the address space, then what is in memory of it
    std::size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::size_t availableMemory()
{
    const auto ofMachine
        = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    rlimit limit {};
    getrlimit(RLIMIT_AS, &limit);
    return std::min(ofMachine, static_cast<std::size_t>(limit.rlim_cur)); // RLIM_INFINITY is the largest there is
}

}
