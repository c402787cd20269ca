#include "values/resident_memory.h"
#include <fstream>
#include <unistd.h>

namespace values {

std::size_t residentMemory()
{
    std::ifstream file("/proc/self/statm"); // in pages: all of the address space, then what is in memory of it
    std::size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}
