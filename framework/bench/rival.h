#pragma once
#include "bench/model.h"
#include <framework/ray.h>
#include <memory>
#include <span>
#include <string>

namespace bench {

// Somebody who can trace. It gets rays in the shape that it likes best before its clock starts, and tells its answers
// after that has stopped.
class Rival {
public:
    virtual ~Rival() = default;

    virtual void load(std::span<const Ray> rays) = 0;
    virtual double traceClosest() = 0; // seconds that it took
    virtual double traceOccluded() = 0;

    [[nodiscard]] virtual float distance(std::size_t ray) const = 0; // of the closest hit, infinity if none
    [[nodiscard]] virtual bool isOccluded(std::size_t ray) const = 0;

    std::string name;
    double buildSeconds = 0.0;
    std::size_t numBytes = 0; // 0: unknown
};

using Rivals = std::vector<std::unique_ptr<Rival>>;

// Each adds what it has.
void addWide(std::span<const Triangle> triangles, Rivals& rivals); // ours, at each instruction level
void addBinary(std::span<const Triangle> triangles, Rivals& rivals); // one box after the other
void addNaive(std::span<const Triangle> triangles, Rivals& rivals); // as a first tree is written
void addSubmission(const std::string& with, std::span<const Triangle> triangles, Rivals& rivals); // its BVH::intersect
void addEmbree(std::span<const Triangle> triangles, Rivals& rivals); // if it was there when this was built

}
