#include "accel/wide/tree.h"
#include "accel/wide/build.h"
#include "accel/wide/margin.h"
#include "files/digest.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace accel {

// To be changed with what a node, a block or a building of them means.
static constexpr std::string_view keptVersion = "wide tree 3";

WideTree::WideTree(const Triangles& triangles, const wide::Kernel& kernel)
    : m_kernel(kernel)
{
    wide::Built built = wide::build(triangles);
    m_nodes = std::move(built.wide.nodes);
    m_blocks = std::move(built.wide.blocks);
    if (!m_blocks.empty())
        viewBox(built.box);
    viewArrays();
}

void WideTree::viewBox(const wide::Box& box)
{
    float halfSize = 0.0f, farthest = 0.0f; // of the middle, from zero
    for (int axis = 0; axis < 3; ++axis) {
        const float lower = 0.5f * box.lower[axis], upper = 0.5f * box.upper[axis];
        m_view.middle[axis] = lower + upper;
        halfSize = std::max(halfSize, upper - lower);
        farthest = std::max(farthest, std::abs(m_view.middle[axis]));
    }
    m_view.margin = wide::marginOfReach * halfSize + wide::marginOfOrigin * farthest;
}

void WideTree::viewArrays()
{
    m_view.nodes = m_nodes.data();
    m_view.blocks = m_blocks.data();
    m_view.numNodes = static_cast<uint32_t>(m_nodes.size());
    m_view.numBlocks = static_cast<uint32_t>(m_blocks.size());
}

// By parts, since there is no array of them.
static std::string nameOf(const wide::Triangles& triangles)
{
    files::Digest digest;
    digest.add(keptVersion);
    std::vector<wide::Triangle> part;
    for (uint32_t i = 0; i < triangles.size();) {
        part.clear();
        for (constexpr uint32_t partSize = 1 << 12; part.size() < partSize && i < triangles.size(); ++i)
            part.push_back(triangles[i]);
        digest.add(std::as_bytes(std::span(part)));
    }
    return digest.hex();
}

WideTree WideTree::keptIn(const files::KeptArrays& folder, const Triangles& triangles)
{
    const std::string name = nameOf(triangles);
    if (WideTree tree { {}, wide::bestKernel() }; tree.load(folder, name))
        return tree;
    WideTree tree(triangles);
    tree.save(folder, name);
    return tree;
}

bool WideTree::load(const files::KeptArrays& folder, const std::string& name)
{
    if (!folder.load(name, m_nodes, m_blocks, m_view.middle, m_view.margin))
        return false;
    viewArrays();
    return true;
}

void WideTree::save(const files::KeptArrays& folder, const std::string& name) const
{
    folder.save(name, m_nodes, m_blocks, m_view.middle, m_view.margin);
}

void WideTree::closest(std::span<const Ray> rays, std::span<std::optional<Hit>> hits, const wide::Kernel& kernel) const
{
    std::array<Hit, wide::mostRays> found;
    kernel.closestOfEach(m_view, rays.data(), static_cast<unsigned>(rays.size()), found.data());
    for (std::size_t i = 0; i < rays.size(); ++i)
        hits[i] = found[i].primitive != Hit::none ? std::optional(found[i]) : std::nullopt;
}

std::optional<WideTree::Hit> WideTree::closest(const Ray& ray, wide::Counters& counters) const
{
    Hit hit;
    return m_kernel.closestCounted(m_view, ray, hit, counters) ? std::optional(hit) : std::nullopt;
}

bool WideTree::occluded(const Ray& ray, wide::Counters& counters) const
{
    return m_kernel.occludedCounted(m_view, ray, counters);
}

std::size_t WideTree::numBytes() const
{
    return m_nodes.size() * sizeof(wide::Node) + m_blocks.size() * sizeof(wide::Block);
}

}
