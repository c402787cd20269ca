#include "grading/oracle/random_scene.h"
#include "shading.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <framework/variant_helper.h>
#include <glm/gtc/quaternion.hpp>
#include <numeric>
#include <random>

using namespace tests;
using grading::Random;

namespace {

// What all models are asked.
struct Case {
    glm::vec3 view, light, lightColor;
    HitInfo hit;
};

// The view lies in front of the surface, the light anywhere.
Case randomCase(Random& random)
{
    Case c { random.direction(), random.direction(), random.color(), {} };
    c.hit.normal = random.direction();
    c.hit.material = grading::randomMaterial(random);
    if (glm::dot(c.view, c.hit.normal) < 0.0f)
        c.view = -c.view;
    return c;
}

using Model = glm::vec3 (*)(World&, const Case&);

glm::vec3 lambert(World& world, const Case& c)
{
    return computeLambertianModel(world.state, c.view, c.light, c.lightColor, c.hit, c.hit.material.kd);
}

glm::vec3 phong(World& world, const Case& c)
{
    return computePhongModel(world.state, c.view, c.light, c.lightColor, c.hit, c.hit.material.kd);
}

glm::vec3 blinnPhong(World& world, const Case& c)
{
    return computeBlinnPhongModel(world.state, c.view, c.light, c.lightColor, c.hit, c.hit.material.kd);
}

// From -1 at t = -1 to 1 at t = 1, so that the colour tells the position that was looked up.
const LinearGradient ruler { .components = { { 1.0f, glm::vec3(1.0f) }, { -1.0f, glm::vec3(-1.0f) } } };

glm::vec3 gradient(World& world, const Case& c)
{
    return computeLinearGradientModel(world.state, c.view, c.light, c.lightColor, c.hit, ruler);
}

glm::vec3 comparison(World& world, const Case& c)
{
    return computeLinearGradientModelComparison(world.state, c.view, c.light, c.lightColor, c.hit, ruler);
}

constexpr std::array<Model, 5> models { lambert, phong, blinnPhong, gradient, comparison };

struct Lobes {
    double phong, blinnPhong;
};

Lobes lobesOf(const Case& c)
{
    const glm::dvec3 n { c.hit.normal }, v { c.view }, l { c.light };
    if (glm::dot(n, l) <= 0.0)
        return { 0.0, 0.0 };
    const double shininess { c.hit.material.shininess };
    return { std::pow(std::max(glm::dot(glm::reflect(-l, n), v), 0.0), shininess),
        std::pow(std::max(glm::dot(n, glm::normalize(l + v)), 0.0), shininess) };
}

glm::dvec3 lit(const Case& c, double lobe)
{
    const double cosine = std::max(glm::dot(glm::dvec3(c.hit.normal), glm::dvec3(c.light)), 0.0);
    return glm::dvec3(c.lightColor) * (cosine * glm::dvec3(c.hit.material.kd) + lobe * glm::dvec3(c.hit.material.ks));
}

constexpr double lobeRounding = 1e-5; // powers up to 20 of numbers rounded to 1e-7

// The sum over the hemisphere above z of a model's light, each direction with its solid angle. Equal areas, the
// middle of each: the error falls with the square of the number.
double sumOverHemisphere(Model model, Case c)
{
    World world;
    constexpr int steps = 400;
    constexpr int turns = 8; // the lobes are round about the normal
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double z = (i + 0.5) / steps;
        for (int j = 0; j < turns; ++j) {
            const double angle = 2.0 * glm::pi<double>() * j / turns;
            c.light = glm::dvec3(std::sqrt(1.0 - z * z) * glm::dvec2(std::cos(angle), std::sin(angle)), z);
            sum += static_cast<double>(model(world, c).x);
        }
    }
    return sum * 2.0 * glm::pi<double>() / (steps * turns);
}

LinearGradient randomGradient(Random& random, int count)
{
    LinearGradient gradient;
    for (int i = 0; i < count; ++i) // a cell each: positions differ
        gradient.components.push_back(
            { -1.0f + 2.0f * (static_cast<float>(i) + random.uniform(0.1f, 0.9f)) / static_cast<float>(count),
                random.color() });
    std::shuffle(gradient.components.begin(), gradient.components.end(), std::mt19937(random.seed()));
    return gradient;
}

}

TEST_CASE("A gradient has each component's colour at its position, in any order", "[shading]")
{
    Random random(1, "gradient positions");
    for (int count = 1; count <= 12; ++count) {
        const LinearGradient gradient = randomGradient(random, count);
        for (const auto& [t, color] : gradient.components)
            CHECK(distance(gradient.sample(t), color) < fewRoundings);
    }
}

TEST_CASE("A gradient is linear between neighbours and level beyond its ends", "[shading]")
{
    Random random(1, "gradient linear");
    for (int count = 1; count <= 12; ++count) {
        const LinearGradient gradient = randomGradient(random, count);
        auto sorted = gradient.components;
        std::ranges::sort(sorted, {}, &LinearGradient::Component::t);
        CHECK(gradient.sample(-1.0f) == sorted.front().color);
        CHECK(gradient.sample(1.0f) == sorted.back().color);
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            const double t0 { sorted[i - 1].t }, t1 { sorted[i].t };
            const auto t = static_cast<float>(glm::mix(t0, t1, static_cast<double>(random.uniform())));
            const double weight = (static_cast<double>(t) - t0) / (t1 - t0);
            // A gap is 0.01 or more: rounded positions move the weight by 1e-5 at most.
            CHECK(distance(gradient.sample(t),
                      glm::mix(glm::dvec3(sorted[i - 1].color), glm::dvec3(sorted[i].color), weight))
                < 1e-5);
        }
    }
}

TEST_CASE("A gradient without components is black, and of equal positions either colour is right", "[shading]")
{
    CHECK(LinearGradient {}.sample(0.3f) == glm::vec3(0.0f));
    const glm::vec3 a { 0.2f }, b { 0.7f };
    const glm::vec3 middle = LinearGradient { { { 0.5f, a }, { -1.0f, a }, { 0.5f, b }, { 1.0f, b } } }.sample(0.5f);
    CHECK((middle == a || middle == b));
}

TEST_CASE("The gradient model looks up the cosine, clamped", "[shading]")
{
    World world;
    Random random(1, "gradient model");
    for (int i = 0; i < 1000; ++i) {
        Case c = randomCase(random);
        const double cosine = glm::dot(glm::dvec3(c.hit.normal), glm::dvec3(c.light));
        CHECK(distance(gradient(world, c), cosine * glm::dvec3(c.lightColor)) < fewRoundings);
        c.light = c.hit.normal * 1.001f; // longer than any rounding of a unit vector
        CHECK(gradient(world, c) == c.lightColor);
        c.light = -c.light;
        CHECK(gradient(world, c) == -c.lightColor);
    }
}

TEST_CASE("The comparison looks up the difference of the two lobes, with one sign everywhere", "[shading]")
{
    World world;
    Random random(1, "comparison");
    std::array<int, 2> numRight {};
    int numPhongBrighter = 0, numCases = 0;
    for (; numCases < 1000; ++numCases) {
        const Case c = randomCase(random);
        const auto [phongLobe, blinnLobe] = lobesOf(c);
        numPhongBrighter += phongLobe > blinnLobe + 0.01;
        const glm::dvec3 expected = (blinnLobe - phongLobe) * glm::dvec3(c.lightColor);
        numRight[0] += distance(comparison(world, c), expected) < lobeRounding;
        numRight[1] += distance(comparison(world, c), -expected) < lobeRounding;
    }
    CHECK(std::max(numRight[0], numRight[1]) == numCases);
    CHECK(numPhongBrighter > 0); // at grazing angles: both halves of the gradient are met
    CHECK(numPhongBrighter < numCases / 2);
}

TEST_CASE("Lambert, Phong and Blinn-Phong follow their formulas", "[shading]")
{
    World world;
    Random random(1, "models");
    for (int i = 0; i < 1000; ++i) {
        const Case c = randomCase(random);
        CHECK(distance(lambert(world, c), lit(c, 0.0)) < fewRoundings);
        CHECK(distance(phong(world, c), lit(c, lobesOf(c).phong)) < lobeRounding);
        CHECK(distance(blinnPhong(world, c), lit(c, lobesOf(c).blinnPhong)) < lobeRounding);
    }
}

TEST_CASE("Phong and Blinn-Phong are never NaN, also where light and view are opposite", "[shading]")
{
    World world;
    Random random(1, "opposite");
    for (int i = 0; i < 1000; ++i) {
        Case c = randomCase(random);
        c.light = -c.view;
        c.hit.material.shininess = static_cast<float>(i);
        const glm::vec3 tangent = glm::normalize(glm::cross(c.view, random.direction()));
        for (const glm::vec3& normal : { c.hit.normal, c.view, -c.view, tangent }) {
            c.hit.normal = normal;
            for (const Model model : models)
                CHECK(isFinite(model(world, c)));
        }
    }
}

TEST_CASE("No model but the gradient's lights a surface from behind", "[shading]")
{
    World world;
    Random random(1, "behind");
    for (int i = 0; i < 1000; ++i) {
        Case c = randomCase(random);
        if (glm::dot(c.light, c.hit.normal) > 0.0f)
            c.light = -c.light;
        for (const Model model : { lambert, phong, blinnPhong, comparison })
            CHECK(model(world, c) == glm::vec3(0.0f));
    }
}

TEST_CASE("Furnace: under equal light from everywhere the models give what their integrals say", "[shading]")
{
    for (const float shininess : { 1.0f, 5.0f, 50.0f }) {
        Case c { { 0, 0, 1 }, {}, glm::vec3(1), {} };
        c.hit.normal = c.view;
        c.hit.material = { .kd = glm::vec3(0.5f), .ks = glm::vec3(0.25f), .shininess = shininess };
        const double s { shininess };
        const double pi = glm::pi<double>();
        const double diffuse = 0.5 * pi;
        const double rule = 1e-3; // of the middles of 400 steps, for a power of 50: (50 / 400)^2 / 24
        CHECK(sumOverHemisphere(lambert, c) == Approx(diffuse).epsilon(rule));
        CHECK(sumOverHemisphere(phong, c) == Approx(diffuse + 0.25 * 2.0 * pi / (s + 1.0)).epsilon(rule));
        const double blinn = 8.0 * pi * (1.0 - std::pow(0.5, (s + 2.0) / 2.0)) / (s + 2.0);
        CHECK(sumOverHemisphere(blinnPhong, c) == Approx(diffuse + 0.25 * blinn).epsilon(rule));
    }
}

TEST_CASE(
    "No highlight is brighter than the light, also where vectors are rounded to more than unit length", "[shading]")
{
    World world;
    constexpr glm::vec3 longUp { 0.0f, 0.0f, 0x1.000002p0f };
    Case c { longUp, longUp, glm::vec3(1.0f), {} };
    c.hit.normal = longUp;
    c.hit.material = { .ks = glm::vec3(0.5f), .shininess = 1e6f };
    for (const Model model : { phong, blinnPhong })
        CHECK(model(world, c) == c.hit.material.ks);
}

TEST_CASE("Turning surface, light and view together changes no model", "[shading]")
{
    World world;
    Random random(1, "turn");
    for (int i = 0; i < 300; ++i) {
        const Case c = randomCase(random);
        const glm::quat turn = glm::angleAxis(random.uniform(0.0f, 6.0f), random.direction());
        Case turned = c;
        turned.view = turn * c.view;
        turned.light = turn * c.light;
        turned.hit.normal = turn * c.hit.normal;
        for (const Model model : models)
            CHECK(distance(model(world, turned), model(world, c)) < 2.0 * lobeRounding);
    }
}

TEST_CASE("The features select the model, and without shading the surface has its own colour", "[shading]")
{
    World world;
    Random random(1, "select");
    const Case c = randomCase(random);
    const auto shade = [&](bool enable, ShadingModel model) {
        world.features.enableShading = enable;
        world.features.shadingModel = model;
        return computeShading(world.state, c.view, c.light, c.lightColor, c.hit);
    };
    CHECK(shade(true, ShadingModel::Lambertian) == lambert(world, c));
    CHECK(shade(true, ShadingModel::Phong) == phong(world, c));
    CHECK(shade(true, ShadingModel::BlinnPhong) == blinnPhong(world, c));
    CHECK(shade(false, ShadingModel::Phong) == c.lightColor * c.hit.material.kd);
    CHECK(computePhongModel(world.state, c.view, c.light, c.lightColor, c.hit) == phong(world, c)); // of 2023-24
}
