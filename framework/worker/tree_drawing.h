#pragma once
#include "worker/shape_message.h"
#include <cstdint>

namespace worker {

// The probe view.tree: what the tree of the open scene draws of itself.
struct TreeRequest {
    int level = -1; // from 0, the root; below that none is drawn
    int leaf = 0; // from 1; below that none is drawn

    [[nodiscard]] bool operator==(const TreeRequest&) const = default;
};

struct TreeDrawing {
    uint32_t numLevels = 0, numLeaves = 0; // as the submission counts them
    std::vector<debug::Shape> shapes;
    std::size_t numDropped = 0; // shapes that were too many
};

inline Message& operator<<(Message& message, const TreeDrawing& t)
{
    return message << t.numLevels << t.numLeaves << t.shapes << t.numDropped;
}

inline Reader& operator>>(Reader& reader, TreeDrawing& t)
{
    return reader >> t.numLevels >> t.numLeaves >> t.shapes >> t.numDropped;
}

}
