#pragma once
#include <cstddef>
#include <cstdint>

namespace debug {

// Counts what this thread's rays do while it lives; the innermost one counts. Other threads are not heard.
class Tally {
public:
    Tally()
        : m_outer(s_innermost)
    {
        s_innermost = this;
    }
    ~Tally() { s_innermost = m_outer; }
    Tally(const Tally&) = delete;
    Tally& operator=(const Tally&) = delete;

    // Of the tree: those whose box the library's own traversal enters, and the boxes that anybody draws.
    [[nodiscard]] uint64_t numNodes() const { return m_numNodes; }
    // By intersectRayWithTriangle, and by the library's own traversal.
    [[nodiscard]] uint64_t numTriangles() const { return m_numTriangles; }

    // Of textures, for the colour of a surface.
    [[nodiscard]] uint64_t numLookups() const { return m_numLookups; }

    // Called by whoever does that: these do nothing where nobody counts.
    static void addNode()
    {
        if (s_innermost)
            ++s_innermost->m_numNodes;
    }
    static void addTriangles(std::size_t count)
    {
        if (s_innermost)
            s_innermost->m_numTriangles += count;
    }
    static void addLookup()
    {
        if (s_innermost)
            ++s_innermost->m_numLookups;
    }
    [[nodiscard]] static bool isOpen() { return s_innermost != nullptr; }

private:
    uint64_t m_numNodes = 0;
    uint64_t m_numTriangles = 0;
    uint64_t m_numLookups = 0;
    Tally* m_outer;

    static inline constinit thread_local Tally* s_innermost = nullptr;
};

}
