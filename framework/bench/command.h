#pragma once
#include <functional>

namespace CLI {
class App;
}

namespace bench {

// A subcommand of ./raywork bench, declared.
struct Command {
    const CLI::App* cli;
    std::function<int()> run; // once the arguments were read; returns an exit code, throws what is bad input
};

}
