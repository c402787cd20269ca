#pragma once
#include "grading/stress/tally.h"
#include "worker/process.h"
#include <filesystem>
#include <memory>

namespace stress {

// Asks a submission's worker, which starts when it is first asked and again whenever it is gone.
class Asker {
public:
    // patience: with a message, whatever else the machine does.
    Asker(std::filesystem::path worker, uint64_t seed, std::chrono::seconds patience);

    // All these inputs: one that takes the worker with it is found by halves, and the others are judged.
    void ask(const Stress& kind, const Range& range, Tally& tally);

private:
    void ask(const Stress& kind, const Range& range, Tally& tally, std::chrono::seconds patience);
    void askAtOnce(const Stress& kind, const Range& range, Tally& tally, std::chrono::seconds patience);

    std::filesystem::path m_worker;
    uint64_t m_seed;
    std::chrono::seconds m_patience;
    std::unique_ptr<worker::Process> m_process;
};

}
