#pragma once
#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace app {

enum ExitCode { Success = 0, BadInput = 2, Unavailable = 69, SubmissionFailed = 70 };

// What a command's main does: reads the arguments and runs the command, which returns its exit code. What it throws
// is bad input, told in a line.
template <typename Command> int runCommand(CLI::App& cli, int argc, char** argv, const Command& run)
{
    try {
        cli.parse(argc, argv);
        return run();
    } catch (const CLI::ParseError& error) {
        return cli.exit(error) == 0 ? Success : BadInput;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return BadInput;
    }
}

}
