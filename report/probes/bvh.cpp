// The probe of the tree over a scene.
#include "bvh.h"
#include "report/probes/tree_facts.h"
#include "values/stopwatch.h"
#include "worker/load_request.h"
#include "worker/probe.h"

namespace report {

static const worker::Probe tree("figures.tree", [](worker::Call& call) {
    const auto [scene, config] = worker::load(call.input.read<worker::RenderRequest>());
    const values::Stopwatch watch;
    const BVH bvh { scene, config.features };
    const double seconds = watch.seconds();
    call.output << TreeFacts { bvh.primitives().size(), bvh.nodes().size(), bvh.numLevels(), bvh.numLeaves(), seconds };
});

}
