#pragma once
#include "accel/wide/tree.h"
#include "bench/model.h"
#include <span>

namespace bench {

enum class Question { Closest, Occluded };

struct RaySet {
    std::string_view name;
    Question question;
    std::vector<Ray> rays;
};

// Primary rays in rows of pixels, what their hits send on in random directions, cosine-weighted, and what they send
// towards the lights. The same for any machine: tree's answers are. At most numRays in each set; no more than a scene
// has hits for in the latter two.
[[nodiscard]] std::vector<RaySet> makeRaySets(const Model& model, const accel::WideTree& tree, std::size_t numRays);

}
