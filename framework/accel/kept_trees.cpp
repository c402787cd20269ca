#include "accel/kept_trees.h"
#include <optional>

namespace accel {
namespace {

    constexpr std::size_t fewestTriangles = 100'000; // of fewer, a tree is built in a fraction of a second

    std::optional<files::KeptArrays> kept;

}

void keepTreesIn(const std::filesystem::path& folder)
{
    kept.emplace(folder);
}

const files::KeptArrays* keptTrees(std::size_t numTriangles)
{
    return kept && numTriangles >= fewestTriangles ? &*kept : nullptr;
}

}
