#pragma once
#include "accel/wide/kernels.h"
#include "accel/wide/large_pages.h"
#include "accel/wide/triangles.h"
#include "files/kept_arrays.h"
#include <framework/ray.h>
#include <optional>
#include <span>
#include <vector>

namespace accel {

// A tree over triangles that answers one ray at a time, as fast as the processor's vectors allow. Watertight: no ray
// passes between triangles that share an edge or a corner.
//
// Both questions are about distances in [0, ray.t]. Edges belong to a triangle, both sides count; a triangle without
// area, seen from where the ray comes, is never met. Of several closest triangles the one of the lowest index is found,
// so the answer depends neither on the tree nor on the processor.
class WideTree {
public:
    using Triangle = wide::Triangle;
    using Triangles = wide::Triangles;
    using Hit = wide::Hit;

    // kernel: one that this processor can run.
    explicit WideTree(const Triangles& triangles, const wide::Kernel& kernel = wide::bestKernel());

    [[nodiscard]] std::optional<Hit> closest(const Ray& ray) const { return closest(ray, m_kernel); }
    [[nodiscard]] std::optional<Hit> closest(const Ray& ray, const wide::Kernel& kernel) const
    {
        Hit hit;
        return kernel.closest(m_view, ray, hit) ? std::optional(hit) : std::nullopt;
    }

    // The same for each of up to mostRays: sooner if they leave one point in directions that differ little.
    void closest(std::span<const Ray> rays, std::span<std::optional<Hit>> hits) const { closest(rays, hits, m_kernel); }
    void closest(std::span<const Ray> rays, std::span<std::optional<Hit>> hits, const wide::Kernel& kernel) const;

    [[nodiscard]] bool occluded(const Ray& ray) const { return occluded(ray, m_kernel); }
    [[nodiscard]] bool occluded(const Ray& ray, const wide::Kernel& kernel) const
    {
        return kernel.occluded(m_view, ray);
    }

    // Whether no segment in the shaft meets a triangle, as `occluded` says: if so, that need not be asked. False where
    // that is not certain.
    [[nodiscard]] bool isClear(const wide::Shaft& shaft) const { return isClear(shaft, m_kernel); }
    [[nodiscard]] bool isClear(const wide::Shaft& shaft, const wide::Kernel& kernel) const
    {
        return kernel.isClear(m_view, shaft);
    }

    // Adds what it tests to the counters.
    [[nodiscard]] std::optional<Hit> closest(const Ray& ray, wide::Counters& counters) const;
    [[nodiscard]] bool occluded(const Ray& ray, wide::Counters& counters) const;

    [[nodiscard]] std::size_t numBytes() const;

    // The tree over these triangles as it was kept or, built now, will be.
    [[nodiscard]] static WideTree keptIn(const files::KeptArrays& folder, const Triangles& triangles);

    WideTree(WideTree&&) = default; // what the view shows stays where it is

private:
    [[nodiscard]] bool load(const files::KeptArrays& folder, const std::string& name);
    void save(const files::KeptArrays& folder, const std::string& name) const;
    void viewBox(const wide::Box& box);
    void viewArrays();

    std::vector<wide::Node, wide::LargePages<wide::Node>> m_nodes;
    std::vector<wide::Block, wide::LargePages<wide::Block>> m_blocks;
    wide::View m_view {};
    const wide::Kernel& m_kernel;
};

}
