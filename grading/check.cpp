#include "grading/check.h"

namespace grading {
namespace {

    std::vector<Check>& registry()
    {
        static std::vector<Check> checks; // first use is before main
        return checks;
    }

}

Check::Check(std::string name_, double points_, std::string usualCause_, Function run_)
    : name(std::move(name_))
    , feature(name.substr(0, name.find('.')))
    , points(points_)
    , usualCause(std::move(usualCause_))
    , run(run_)
{
    registry().push_back(*this);
}

const std::vector<Check>& Check::all()
{
    return registry();
}

}
