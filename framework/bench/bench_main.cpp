// ./raywork bench: measures the library against others.
#include "app/run_command.h"
#include "bench/kernels.h"
#include "bench/traversal.h"
#include "bench/watertight.h"
#include <algorithm>

int main(int argc, char** argv)
{
    CLI::App cli { "Measures the library against others.", "./raywork bench" };
    cli.require_subcommand(1);
    const bench::Command commands[]
        = { bench::declareTraversal(cli), bench::declareWatertight(cli), bench::declareKernels(cli) };
    return app::runCommand(cli, argc, argv, [&] {
        return std::ranges::find_if(commands, [](const bench::Command& command) {
            return command.cli->parsed();
        })->run();
    });
}
