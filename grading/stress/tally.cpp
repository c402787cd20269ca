#include "grading/stress/tally.h"
#include <algorithm>

namespace stress {

void Tally::addRight(std::size_t count, double largest)
{
    const std::lock_guard lock(m_mutex);
    asked += count;
    largestUlps = std::max(largestUlps, largest);
}

void Tally::add(Failure failure)
{
    const std::lock_guard lock(m_mutex);
    ++asked;
    ++failed;
    largestUlps = std::max(largestUlps, failure.judgement.ulps);
    const auto place = std::ranges::lower_bound(failures, failure.input, {}, &Failure::input);
    failures.insert(place, std::move(failure));
    if (failures.size() > mostKept)
        failures.pop_back();
}

void Tally::addUnwritten(std::size_t count, const std::vector<std::string>& functions)
{
    const std::lock_guard lock(m_mutex);
    asked += count;
    unwritten += count;
    unwrittenFunctions = functions;
}

void Tally::giveUpOn(std::size_t count)
{
    const std::lock_guard lock(m_mutex);
    asked += count;
    failed += count;
}

// A crash costs milliseconds, an endless loop the patience for an answer.
void Tally::countLostWorker(bool wasSlow)
{
    const std::lock_guard lock(m_mutex);
    m_lostWorkers += wasSlow ? 3 : 1;
}

bool Tally::isGivenUp() const
{
    const std::lock_guard lock(m_mutex);
    return m_lostWorkers >= mostLost;
}

}
