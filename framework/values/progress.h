#pragma once
#include <atomic>
#include <cstdint>

namespace values {

// How far some work is, for other threads to look at. Any number of threads may share the work.
class Progress {
public:
    void expect(uint64_t steps) { m_expected += steps; }
    void add(uint64_t steps) { m_done += steps; }

    // In [0, 1] of what is expected so far.
    [[nodiscard]] float fraction() const
    {
        const uint64_t expected = m_expected;
        return expected == 0 ? 0.0f : static_cast<float>(m_done) / static_cast<float>(expected);
    }

private:
    std::atomic<uint64_t> m_expected = 0, m_done = 0;
};

}
