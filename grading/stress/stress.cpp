#include "grading/stress/stress.h"

namespace stress {
namespace {

    std::vector<Stress>& registry()
    {
        static std::vector<Stress> kinds; // first use is before main
        return kinds;
    }

}

void Stress::enroll() const
{
    registry().push_back(*this);
}

const std::vector<Stress>& Stress::all()
{
    return registry();
}

}
