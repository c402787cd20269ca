#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sandbox {

// Of each process.
struct Limits {
    std::optional<std::size_t> memoryBytes; // of address space
    std::optional<std::size_t> fileBytes; // of each file written, what it prints included
    std::optional<std::chrono::seconds> cpuTime;
};

// What a program sees of the file system beside the system's own programs and libraries: nothing, unless it is listed.
struct View {
    std::vector<std::filesystem::path> readable; // files and folders; "/" is everything
    std::filesystem::path writable; // one folder, may be empty
    bool hasTemporary = false; // an empty /tmp of its own
};

// A program that nobody trusts, and all that it may do.
struct Command {
    std::vector<std::string> words; // the program, by its absolute path, and its arguments
    std::filesystem::path folder = "/"; // where it runs
    int socket = -1; // its descriptor number 3; -1: none
    int output = -1; // what it prints goes to this descriptor; -1: to where ours goes
    Limits limits {};
    View view {};
    bool mayStartProcesses = false; // threads are always allowed
};

}
