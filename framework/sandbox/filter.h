#pragma once
#include <vector>

struct sock_filter;

namespace sandbox {

// A program for the kernel that refuses the system calls by which a process could outlive its limits or reach others:
// starting processes, leaving its process group, sockets, signals to others, namespaces, memory that no limit counts.
// Threads are allowed. Throws
// std::system_error where there are no such filters.
[[nodiscard]] const std::vector<sock_filter>& systemCallFilter();

}
