#include "grading/validate/sample.h"

namespace grading {
namespace {

    std::vector<Solution> spread(const std::vector<Solution>& all, std::size_t wanted)
    {
        if (wanted >= all.size())
            return all;
        std::vector<Solution> some;
        for (std::size_t i = 0; i < wanted; ++i)
            some.push_back(all[i * all.size() / wanted]);
        return some;
    }

}

Bank sampleOf(const Bank& bank, std::size_t wrong)
{
    return { spread(bank.wrong, wrong), spread(bank.accepted, wrong / 2) };
}

}
