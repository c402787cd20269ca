#include "accel/counting_bvh.h"
#include "debug/cause.h"
#include <mutex>
#include <set>

namespace accel {
namespace {

    struct Registry {
        std::mutex mutex;
        std::set<const RayCounts*> running;
        RayCounts ended;
    };

    Registry& registry()
    {
        static Registry* const registry = new Registry; // outlives every thread
        return *registry;
    }

}

CountingBVH::Counter::Counter()
{
    const std::scoped_lock lock(registry().mutex);
    registry().running.insert(&rays);
}

CountingBVH::Counter::~Counter()
{
    const std::scoped_lock lock(registry().mutex);
    registry().running.erase(&rays);
    registry().ended += rays;
}

uint64_t& CountingBVH::Counter::ofCause()
{
    const debug::Cause& cause = debug::Because::now();
    if (cause.way == debug::Way::Shadow)
        return rays.shadow;
    return cause.bounce == 0 ? rays.camera : rays.bounced;
}

CountingBVH::Counter& CountingBVH::counter()
{
    thread_local Counter counter;
    return counter;
}

RayCounts CountingBVH::rayCounts()
{
    const std::scoped_lock lock(registry().mutex);
    RayCounts sum = registry().ended;
    for (const RayCounts* rays : registry().running)
        sum += *rays;
    return sum;
}

}
