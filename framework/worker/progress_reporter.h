#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace worker {

// Reports how far something is, ten times a second, while it lives.
class ProgressReporter {
public:
    // Both are called by a thread of its own. fraction: in [0, 1].
    ProgressReporter(std::function<float()> fraction, std::function<void(float)> report)
        : m_thread([this, fraction = std::move(fraction), report = std::move(report)](const std::stop_token& stop) {
            std::mutex mutex;
            std::unique_lock lock(mutex);
            while (!m_wake.wait_for(lock, stop, std::chrono::milliseconds(100), [&] { return stop.stop_requested(); }))
                report(fraction());
        })
    {
    }

private:
    std::condition_variable_any m_wake;
    std::jthread m_thread;
};

}
