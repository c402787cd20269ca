#include "grading/check.h"
#include "grading/feature.h"
#include <catch2/catch.hpp>
#include <numeric>
#include <set>

TEST_CASE("The checks of each feature add up to its points, and all features to 100", "[points]")
{
    double all = 0.0;
    for (const grading::Feature& feature : grading::gradedFeatures) {
        CAPTURE(feature.name);
        double sum = 0.0;
        for (const grading::Check& check : grading::Check::all())
            sum += check.feature == feature.name ? check.points : 0.0;
        CHECK(sum == feature.points); // halves and quarters: exact
        all += sum;
    }
    CHECK(all == 100.0);
}

TEST_CASE("Every check has a name of its own, points, and a feature that is graded", "[points]")
{
    std::set<std::string> names;
    for (const grading::Check& check : grading::Check::all()) {
        CAPTURE(check.name);
        CHECK(names.insert(check.name).second);
        CHECK(check.points > 0.0);
        CHECK_FALSE(check.usualCause.empty());
        CHECK(std::ranges::count(grading::gradedFeatures, check.feature, &grading::Feature::name) == 1);
    }
}
