#pragma once
#include "sandbox/command.h"
#include <string>
#include <vector>

// Bubblewrap, a program that puts another one into namespaces of its own: it sees no other process, no network, and of
// the file system only what it is shown.
namespace sandbox {

// Why nothing can be locked in on this machine, one line; empty if it can. Asked once.
[[nodiscard]] const std::string& whyNoBubblewrap();

// Does without, from now on: then limits and the filter of system calls are all. Before anything is asked or started.
void turnOffBubblewrap();

// What stands before a command's words. Bubblewrap's environment becomes the command's. It tells on one descriptor
// which process is the first in the sandbox, and reads a filter of system calls from another (-1: none).
[[nodiscard]] std::vector<std::string> bubblewrapWords(const View& view, int info, int filter);

}
