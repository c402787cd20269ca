#pragma once
#include "grading/stress/stress.h"
#include <mutex>
#include <string>
#include <vector>

namespace stress {

// A case that failed: what was asked, what came and what was expected.
struct Failure {
    std::size_t input; // its number
    std::string word; // wrong, crashed, timed out or malformed
    std::string asked;
    Judgement judgement;
};

// What became of the inputs of one kind. Threads add to it side by side.
class Tally {
public:
    static constexpr std::size_t mostKept = 5; // of the failures, those with the lowest numbers

    void addRight(std::size_t count, double largestUlps);
    void add(Failure failure);
    void addUnwritten(std::size_t count, const std::vector<std::string>& functions);

    // Inputs like those that take a worker with them are asked no more after a few times, and count as failed.
    void countLostWorker(bool wasSlow);
    [[nodiscard]] bool isGivenUp() const;
    void giveUpOn(std::size_t count);

    std::size_t asked = 0, failed = 0, unwritten = 0; // inputs; those that failed or were not attempted are among asked
    double largestUlps = 0.0; // of right answers and wrong ones
    std::vector<Failure> failures;
    std::vector<std::string> unwrittenFunctions; // the stubs that were met

private:
    static constexpr std::size_t mostLost = 6;

    mutable std::mutex m_mutex;
    std::size_t m_lostWorkers = 0;
};

}
