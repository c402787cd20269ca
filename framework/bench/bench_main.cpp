// ./raywork bench: measures how fast things are.
#include "app/run_command.h"
#include "bench/accuracy.h"
#include "bench/adaptive.h"
#include "bench/error.h"
#include "bench/grade.h"
#include "bench/kernels.h"
#include "bench/render.h"
#include "bench/skip.h"
#include "bench/traversal.h"
#include "bench/watertight.h"
#include <algorithm>

int main(int argc, char** argv)
{
    CLI::App cli { "Measures how fast the library is, and a grading.", "./raywork bench" };
    cli.require_subcommand(1);
    const bench::Command commands[] = { bench::declareTraversal(cli), bench::declareAccuracy(cli),
        bench::declareWatertight(cli), bench::declareRender(cli), bench::declareSkip(cli), bench::declareError(cli),
        bench::declareAdaptive(cli), bench::declareKernels(cli), bench::declareGrade(cli) };
    return app::runCommand(cli, argc, argv, [&] {
        return std::ranges::find_if(commands, [](const bench::Command& command) {
            return command.cli->parsed();
        })->run();
    });
}
