#include "submission/build_step.h"
#include "sandbox/child.h"
#include <cerrno>
#include <fcntl.h>
#include <system_error>

namespace submission {

bool runBuildStep(const std::vector<std::string>& words, const std::filesystem::path& folder, const std::string& log,
    const std::vector<std::filesystem::path>& readable)
{
    constexpr std::chrono::seconds patience { 60 }; // a course file takes two or three
    const sandbox::File output { open((folder / log).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644) };
    if (output < 0)
        throw std::system_error(errno, std::generic_category(), (folder / log).string());
    sandbox::Command command;
    command.words = words;
    command.folder = folder;
    command.output = output;
    // An object of a course file has a tenth of a megabyte, and a compiler takes half a gigabyte for it.
    command.limits = { std::size_t(4) << 30, std::size_t(64) << 20, patience };
    command.view = { readable, folder, true };
    command.mayStartProcesses = true; // a compiler driver starts the compiler, the assembler, the linker
    sandbox::Child child { command };
    return child.hasEndedBy(sandbox::Clock::now() + patience);
}

}
