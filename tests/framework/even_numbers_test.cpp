#include "values/even_numbers.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using values::EvenNumbers;

namespace {

constexpr uint32_t numRays = 64;

// Each of the numbers in [0, 1) has its own of as many equal intervals.
bool isEven(std::vector<float> numbers)
{
    std::ranges::sort(numbers);
    const auto count = static_cast<float>(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (static_cast<std::size_t>(numbers[i] * count) != i)
            return false;
    return true;
}

struct Coordinates {
    std::vector<float> x, y;
};

// Of as many points as are expected.
Coordinates takePoints(EvenNumbers& even)
{
    even.expectPoints(numRays);
    Coordinates points;
    for (uint32_t i = 0; i < numRays; ++i) {
        const glm::vec2 point = even.next2d();
        points.x.push_back(point.x);
        points.y.push_back(point.y);
    }
    return points;
}

}

TEST_CASE("Even numbers, where a pixel's rays begin is even", "[sampling]")
{
    EvenNumbers even(3);
    const Coordinates points = takePoints(even);
    CHECK(isEven(points.x));
    CHECK(isEven(points.y));
}

TEST_CASE("Even numbers, what is expected in each ray is even over all rays and within each", "[sampling]")
{
    constexpr uint32_t numSamples = 4;
    EvenNumbers even(3);
    std::vector<float> ofFirstLight, ofSecondLight;
    for (uint32_t ray = 0; ray < numRays; ++ray) {
        even.startRay(ray);
        std::vector<float> ofRay;
        even.expectPoints(numSamples);
        for (uint32_t i = 0; i < numSamples; ++i)
            ofRay.push_back(even.next2d().y);
        CHECK(isEven(ofRay));
        ofFirstLight.insert(ofFirstLight.end(), ofRay.begin(), ofRay.end());
        even.expectNumbers(numSamples);
        for (uint32_t i = 0; i < numSamples; ++i)
            ofSecondLight.push_back(even.next1d());
    }
    CHECK(isEven(ofFirstLight));
    CHECK(isEven(ofSecondLight));
}

TEST_CASE("Even numbers, what nobody expects is even over all rays, each call on its own", "[sampling]")
{
    EvenNumbers even(3);
    std::vector<float> first, second;
    for (uint32_t ray = 0; ray < numRays; ++ray) {
        even.startRay(ray);
        first.push_back(even.next1d());
        second.push_back(even.next2d().x);
    }
    CHECK(isEven(first));
    CHECK(isEven(second));
}

TEST_CASE("Even numbers, purposes and pixels do not depend on one another", "[sampling]")
{
    // The mean of the products of deviations, over many pixels: its deviation is 1 / 12 / sqrt(numPixels).
    constexpr uint32_t numPixels = 40000;
    double ofPurposes = 0.0, ofPixels = 0.0, before = 0.0;
    for (uint32_t pixel = 0; pixel < numPixels; ++pixel) {
        EvenNumbers even(pixel);
        even.startRay(5);
        const double a = double(even.next1d()) - 0.5, b = double(even.next1d()) - 0.5;
        ofPurposes += a * b;
        ofPixels += a * before;
        before = a;
    }
    const double deviation = 1.0 / 12.0 / std::sqrt(double(numPixels));
    CHECK(std::abs(ofPurposes / numPixels) < 5.0 * deviation); // once in two million by chance; the seeds are fixed
    CHECK(std::abs(ofPixels / numPixels) < 5.0 * deviation);
}

TEST_CASE("Even numbers, of pairs each coordinate is even, and they do not depend on each other", "[sampling]")
{
    constexpr uint32_t numPixels = 1000;
    double products = 0.0;
    for (uint32_t pixel = 0; pixel < numPixels; ++pixel) {
        EvenNumbers even(pixel, EvenNumbers::Method::OwenPairs);
        const Coordinates points = takePoints(even);
        REQUIRE(isEven(points.x));
        REQUIRE(isEven(points.y));
        for (uint32_t i = 0; i < numRays; ++i)
            products += (double(points.x[i]) - 0.5) * (double(points.y[i]) - 0.5);
    }
    // The correlation of a random order of n has the deviation 1 / sqrt(n - 1), a pixel.
    const double correlation = products * 12.0 / (numRays * numPixels);
    CHECK(std::abs(correlation) < 5.0 / std::sqrt((numRays - 1.0) * numPixels)); // once in two million by chance
}

TEST_CASE("Even numbers, a pixel's rays can come in parts", "[sampling]")
{
    struct Asked {
        std::vector<glm::vec2> points;
        std::vector<float> numbers;

        void ask(EvenNumbers& even, uint32_t count)
        {
            even.expectPoints(count);
            for (uint32_t i = 0; i < count; ++i)
                points.push_back(even.next2d());
            for (uint32_t i = 0; i < count; ++i) {
                even.startRay(i);
                even.expectPoints(2);
                points.push_back(even.next2d());
                points.push_back(even.next2d());
                numbers.push_back(even.next1d()); // of which nobody told
            }
        }
    };
    EvenNumbers all(3);
    Asked together, first, second;
    together.ask(all, numRays);
    EvenNumbers firstHalf(3), secondHalf(3, EvenNumbers::Method::Owen, numRays / 2);
    first.ask(firstHalf, numRays / 2);
    second.ask(secondHalf, numRays / 2);
    first.numbers.insert(first.numbers.end(), second.numbers.begin(), second.numbers.end());
    CHECK(first.numbers == together.numbers);
    constexpr auto half = numRays / 2;
    const auto part = [](const std::vector<glm::vec2>& points, uint32_t from, uint32_t to) {
        return std::vector<glm::vec2>(points.begin() + from, points.begin() + to);
    };
    CHECK(part(first.points, 0, half) == part(together.points, 0, half));
    CHECK(part(second.points, 0, half) == part(together.points, half, numRays));
    CHECK(part(first.points, half, half + numRays) == part(together.points, numRays, 2 * numRays));
    CHECK(part(second.points, half, half + numRays) == part(together.points, 2 * numRays, 3 * numRays));
}
