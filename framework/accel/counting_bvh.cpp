#include "accel/counting_bvh.h"
#include <mutex>
#include <set>

namespace accel {
namespace {

    struct Registry {
        std::mutex mutex;
        std::set<const uint64_t*> running;
        uint64_t ended = 0;
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

CountingBVH::Counter& CountingBVH::counter()
{
    thread_local Counter counter;
    return counter;
}

uint64_t CountingBVH::numRays()
{
    const std::scoped_lock lock(registry().mutex);
    uint64_t sum = registry().ended;
    for (const uint64_t* rays : registry().running)
        sum += *rays;
    return sum;
}

}
