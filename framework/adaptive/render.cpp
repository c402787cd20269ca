#include "adaptive/render.h"
#include "values/stopwatch.h"
#include <algorithm>
#include <cmath>

namespace adaptive {
namespace {

    double largest(const std::vector<double>& errors)
    {
        return *std::ranges::max_element(errors);
    }

    // Of the rays, if the variance of each pixel falls as its rays become more.
    float shareDone(const Picture& picture, double error)
    {
        double done = 0.0, all = 0.0;
        for (std::size_t i = 0; i < picture.errors().size(); ++i) {
            const double numRays = picture.estimates()[i].numRays, excess = picture.errors()[i] / error;
            done += numRays;
            all += std::min(numRays * std::max(excess * excess, 1.0), static_cast<double>(Picture::mostRays));
        }
        return static_cast<float>(done / all);
    }

}

Picture render(const PixelRays& rays, glm::ivec2 size, const Goal& goal, const std::function<void(float)>& progress)
{
    const values::Stopwatch watch;
    const auto goesOn = [&] { return !goal.seconds || watch.seconds() < *goal.seconds; };
    Picture picture(rays, size);
    // In a limited time everywhere a little better first; otherwise at once as good as wanted.
    double error = goal.seconds ? std::max(largest(picture.errors()), goal.error) : goal.error;
    for (;;) {
        progress(goal.seconds ? static_cast<float>(watch.seconds() / *goal.seconds) : shareDone(picture, goal.error));
        const bool refined = picture.refineAbove(error, goesOn);
        if (!goesOn() || (!refined && error <= goal.error))
            return picture;
        if (!refined)
            error = std::max(error * std::sqrt(0.5), goal.error);
    }
}

Summary summarize(const Picture& picture)
{
    Summary summary { .fewestSamples = Picture::mostRays };
    for (const Estimate& estimate : picture.estimates()) {
        summary.numSamples += estimate.numRays;
        summary.fewestSamples = std::min(summary.fewestSamples, estimate.numRays);
        summary.mostSamples = std::max(summary.mostSamples, estimate.numRays);
    }
    double sum = 0.0;
    for (const double error : picture.errors())
        sum += error * error;
    summary.error = std::sqrt(sum / static_cast<double>(picture.errors().size()));
    summary.largestError = largest(picture.errors());
    return summary;
}

}
