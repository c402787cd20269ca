#pragma once
#include "accel/counting_bvh.h"
#include "debug/cause.h"
#include "debug/tally.h"
#include "worker/work.h"
#include <atomic>

namespace worker {

// Counts rays while it lives, and of other work what threads do while one of its parts lives.
class CountedWork {
public:
    // What its thread does, rays to lights told apart.
    class Part {
    public:
        explicit Part(CountedWork& all)
            : m_all(all)
        {
        }
        ~Part()
        {
            m_all.m_numNodes += m_tally.numNodes();
            m_all.m_numTriangles += m_tally.numTriangles();
            m_all.m_numLookups += m_tally.numLookups();
        }
        Part(const Part&) = delete;
        Part& operator=(const Part&) = delete;

    private:
        CountedWork& m_all;
        const debug::Watch m_watch;
        const debug::Tally m_tally;
    };

    // Only while nobody traces.
    [[nodiscard]] Work sum() const
    {
        return { accel::CountingBVH::rayCounts() - m_before, m_numNodes, m_numTriangles, m_numLookups };
    }

private:
    accel::RayCounts m_before = accel::CountingBVH::rayCounts();
    std::atomic<uint64_t> m_numNodes = 0, m_numTriangles = 0, m_numLookups = 0;
};

}
