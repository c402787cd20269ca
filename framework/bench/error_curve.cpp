#include "bench/error_curve.h"
#include "truth/light.h"
#include "truth/polygon.h"
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace bench {

std::vector<double> truthsOf(worker::Integrand integrand)
{
    std::vector<double> truths;
    if (integrand == worker::Integrand::Edge || integrand == worker::Integrand::AxisEdge) {
        const worker::EdgePicture picture = worker::edgePicture(integrand);
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            const glm::dvec2 lower(picture.pixels[i]);
            const truth::Polygon triangle(picture.triangles[i].begin(), picture.triangles[i].end());
            truths.push_back(truth::areaOf(truth::clipToRectangle(triangle, lower, lower + 1.0)));
        }
        return truths;
    }
    const worker::LitFloor floor = worker::litFloor(integrand);
    const std::vector<glm::dvec3> blocker(floor.blocker.begin(), floor.blocker.end());
    for (const glm::vec3& point : floor.points) {
        const truth::Receiver receiver { glm::dvec3(point), { 0.0, 1.0, 0.0 }, glm::dvec3(1.0) };
        truths.push_back(truth::contribution(floor.light, receiver, blocker).x);
    }
    return truths;
}

ErrorPoint errorOf(const worker::Estimates& estimates, const std::vector<double>& truths, uint32_t numSamples)
{
    double sum = 0.0, sumOfSquares = 0.0;
    for (std::size_t i = 0; i < estimates.values.size(); ++i) {
        const double error = static_cast<double>(estimates.values[i]) - truths[i % truths.size()];
        sum += error;
        sumOfSquares += error * error;
    }
    const auto number = static_cast<double>(estimates.values.size());
    return { numSamples, std::sqrt(sumOfSquares / number), sum / number, estimates.secondsEach };
}

Slope fitSlope(const std::vector<ErrorPoint>& points)
{
    const auto number = static_cast<double>(points.size());
    double meanX = 0.0, meanY = 0.0;
    for (const ErrorPoint& point : points) {
        meanX += std::log(point.numSamples) / number;
        meanY += std::log(point.error) / number;
    }
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const ErrorPoint& point : points) {
        const double x = std::log(point.numSamples) - meanX, y = std::log(point.error) - meanY;
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    const double slope = xy / xx, freedom = number - 2.0;
    const double deviation = std::sqrt(std::max(0.0, yy - slope * xy) / freedom / xx);
    return { slope, deviation * boost::math::quantile(boost::math::students_t(freedom), 0.975) };
}

std::optional<double> secondsToReach(double error, const std::vector<ErrorPoint>& points)
{
    for (std::size_t i = 1; i < points.size(); ++i) {
        const ErrorPoint &before = points[i - 1], &after = points[i];
        if (before.error >= error && error >= after.error && before.error > after.error) {
            const double part = std::log(before.error / error) / std::log(before.error / after.error);
            return before.seconds * std::pow(after.seconds / before.seconds, part);
        }
    }
    return {};
}

Gain gainOver(const ErrorPoint& uniform, const ErrorPoint& point)
{
    const double samplesAtEqualError = uniform.numSamples * std::pow(uniform.error / point.error, 2.0);
    const double secondsAtEqualError = uniform.seconds * std::pow(uniform.error / point.error, 2.0);
    const double errorAtEqualTime = uniform.error * std::sqrt(uniform.seconds / point.seconds);
    return { samplesAtEqualError / point.numSamples, secondsAtEqualError / point.seconds,
        errorAtEqualTime / point.error };
}

}
