#include "submission/build_step.h"
#include "files/text.h"
#include "sandbox/child.h"
#include <cerrno>
#include <fcntl.h>
#include <system_error>

namespace submission {

// A compiler driver tells so of a compiler that was killed, and ends by itself.
static bool tellsOfKilled(const BuildStep& step)
{
    return files::readText(step.folder / step.log).find("Killed signal") != std::string::npos;
}

StepEnd run(const BuildStep& step)
{
    constexpr std::chrono::seconds patience { 60 }; // a course file takes two or three
    const std::filesystem::path log = step.folder / step.log;
    const sandbox::File output { open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644) };
    if (output < 0)
        throw std::system_error(errno, std::generic_category(), log.string());
    sandbox::Command command;
    command.words = step.words;
    command.folder = step.folder;
    command.output = output;
    // An object of a course file has a tenth of a megabyte, and a compiler takes half a gigabyte for it.
    command.limits = { std::size_t(4) << 30, std::size_t(16) << 20, patience };
    command.view = { step.readable, step.folder, true };
    command.mayStartProcesses = true; // a compiler driver starts the compiler, the assembler, the linker
    sandbox::Child child { command };
    if (!child.hasEndedBy(sandbox::Clock::now() + patience))
        return StepEnd::Stopped;
    const sandbox::Child::End end = child.kill();
    if (end.exitCode == 0)
        return StepEnd::Succeeded;
    return end.signal != 0 || tellsOfKilled(step) ? StepEnd::Stopped : StepEnd::Failed;
}

}
