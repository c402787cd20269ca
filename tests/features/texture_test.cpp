#include "shading.h"
#include "texture.h"
#include "world.h"
#include <catch2/catch.hpp>

using namespace tests;
using grading::Random;

namespace {

constexpr std::array<glm::ivec2, 5> sizes { { { 1, 1 }, { 1, 6 }, { 7, 1 }, { 3, 4 }, { 16, 5 } } };

Image randomImage(Random& random, const glm::ivec2& size)
{
    Image image(size.x, size.y);
    for (int i = 0; i < size.x * size.y; ++i)
        image.set_pixel(i, random.vec3());
    return image;
}

glm::dvec3 texel(const Image& image, int i, int j)
{
    const glm::ivec2 at = glm::clamp(glm::ivec2(i, j), glm::ivec2(0), glm::ivec2(image.width, image.height) - 1);
    return glm::dvec3(image.get_pixel(at.y * image.width + at.x));
}

// The texture coordinates of a point given in texels.
glm::vec2 coordinates(const Image& image, const glm::dvec2& inTexels)
{
    return inTexels / glm::dvec2(image.width, image.height);
}

// The weights as the overlap of the texel-sized square around the point with each texel.
glm::dvec3 bilinearByOverlap(const Image& image, const glm::dvec2& point)
{
    const glm::ivec2 first { glm::floor(point - 0.5) };
    glm::dvec3 sum { 0.0 };
    for (int j = first.y; j <= first.y + 1; ++j) {
        for (int i = first.x; i <= first.x + 1; ++i) {
            const glm::dvec2 overlap = 1.0 - glm::abs(point - (glm::dvec2(i, j) + 0.5));
            sum += overlap.x * overlap.y * texel(image, i, j);
        }
    }
    return sum;
}

// Coordinates of about 1 are rounded by 6e-8, which is 1e-6 of a texel in a row of 16.
constexpr double texelRounding = 4e-6;

}

TEST_CASE("Texture nearest, is the texel that covers the point, from edge to edge", "[texture]")
{
    Random random(1, "nearest");
    for (const glm::ivec2& size : sizes) {
        const Image image = randomImage(random, size);
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                for (const glm::dvec2& in :
                    { glm::dvec2(0.5), glm::dvec2(0.001), glm::dvec2(0.999), glm::dvec2(0.001, 0.999) })
                    CHECK(glm::dvec3(sampleTextureNearest(image, coordinates(image, glm::dvec2(i, j) + in)))
                        == texel(image, i, j));
    }
}

TEST_CASE("Texture nearest and bilinear, row 0 is the row that v = 0 addresses", "[texture]")
{
    Image image(1, 2);
    image.set_pixel(0, glm::vec3(1, 0, 0));
    image.set_pixel(1, glm::vec3(0, 1, 0));
    for (const auto sample : { sampleTextureNearest, sampleTextureBilinear }) {
        CHECK(sample(image, { 0.5f, 0.0f }) == glm::vec3(1, 0, 0));
        CHECK(sample(image, { 0.5f, 1.0f }) == glm::vec3(0, 1, 0));
    }
}

TEST_CASE("Texture nearest and bilinear, take the edge's texels beyond the edge, however far", "[texture]")
{
    Random random(1, "beyond");
    const float infinity = std::numeric_limits<float>::infinity();
    for (const glm::ivec2& size : sizes) {
        const Image image = randomImage(random, size);
        for (const auto sample : { sampleTextureNearest, sampleTextureBilinear }) {
            for (const float far : { 1.0f, 1.5f, 1e9f, 1e30f, infinity }) {
                const glm::dvec2 middle { 0.5 * size.x, 0.5 };
                CHECK(sample(image, { -far, -far }) == glm::vec3(texel(image, 0, 0)));
                CHECK(sample(image, { far, far }) == glm::vec3(texel(image, size.x - 1, size.y - 1)));
                CHECK(sample(image, { coordinates(image, middle).x, -far })
                    == sample(image, coordinates(image, { 0.5 * size.x, 0.25 })));
            }
        }
    }
}

TEST_CASE("Texture bilinear, is the texel at its centre and the mean halfway between two", "[texture]")
{
    Random random(1, "centres");
    for (const glm::ivec2& size : sizes) {
        const Image image = randomImage(random, size);
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const glm::dvec2 centre = glm::dvec2(i, j) + 0.5;
                const auto sample
                    = [&](const glm::dvec2& at) { return sampleTextureBilinear(image, coordinates(image, at)); };
                const glm::dvec3 here = texel(image, i, j);
                CHECK(distance(sample(centre), here) < texelRounding);
                CHECK(distance(sample(centre + glm::dvec2(0.5, 0)), 0.5 * (here + texel(image, i + 1, j)))
                    < texelRounding);
                CHECK(distance(sample(centre + glm::dvec2(0, 0.5)), 0.5 * (here + texel(image, i, j + 1)))
                    < texelRounding);
            }
        }
    }
}

TEST_CASE("Texture bilinear, weighs each texel by its overlap with the square around the point", "[texture]")
{
    Random random(1, "overlap");
    for (const glm::ivec2& size : sizes) {
        const Image image = randomImage(random, size);
        for (int i = 0; i < 500; ++i) {
            const glm::vec2 uv = random.vec2(-0.2f, 1.2f);
            const glm::dvec2 inTexels = glm::dvec2(uv) * glm::dvec2(size);
            CHECK(distance(sampleTextureBilinear(image, uv), bilinearByOverlap(image, inTexels)) < texelRounding);
        }
    }
}

TEST_CASE("Texture bilinear, is continuous across texel borders", "[texture]")
{
    Random random(1, "continuous");
    constexpr double step = 1e-4; // texels
    constexpr double steepest
        = 2.0 * 1.7321; // colours differ by the diagonal of the unit cube at most, along both axes
    for (const glm::ivec2& size : sizes) {
        const Image image = randomImage(random, size);
        for (double at = -1.0; at <= 17.0; at += 0.5) {
            const double other = static_cast<double>(random.uniform(-1.0f, 17.0f));
            for (const auto& [a, b] :
                { std::pair(glm::dvec2(at - step / 2.0, other), glm::dvec2(at + step / 2.0, other)),
                    std::pair(glm::dvec2(other, at - step / 2.0), glm::dvec2(other, at + step / 2.0)) })
                CHECK(distance(sampleTextureBilinear(image, coordinates(image, a)),
                          sampleTextureBilinear(image, coordinates(image, b)))
                    < steepest * step + texelRounding);
        }
    }
}

TEST_CASE("Texture bilinear, mirrors with the picture", "[texture]")
{
    Random random(1, "mirror");
    for (const glm::ivec2& size : sizes) {
        const Image image = randomImage(random, size);
        Image mirrored(size.x, size.y);
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                mirrored.set_pixel(j * size.x + i, glm::vec3(texel(image, size.x - 1 - i, j)));
        for (int i = 0; i < 200; ++i) {
            const glm::vec2 uv = random.vec2();
            CHECK(distance(sampleTextureBilinear(mirrored, { 1.0f - uv.x, uv.y }), sampleTextureBilinear(image, uv))
                < texelRounding);
        }
    }
}

TEST_CASE("A surface has its texture's colour where it has one and the features want it", "[texture]")
{
    World world;
    Random random(1, "kd");
    const Image image = randomImage(random, { 3, 4 });
    HitInfo hit;
    hit.texCoord = { 0.4f, 0.7f };
    hit.material = { .kd = glm::vec3(0.25f), .kdTexture = &image };
    CHECK(sampleMaterialKd(world.state, hit) == glm::vec3(0.25f));
    world.features.enableTextureMapping = true;
    CHECK(sampleMaterialKd(world.state, hit) == sampleTextureNearest(image, hit.texCoord));
    world.features.enableBilinearTextureFiltering = true;
    CHECK(sampleMaterialKd(world.state, hit) == sampleTextureBilinear(image, hit.texCoord));
    hit.material.kdTexture = nullptr;
    CHECK(sampleMaterialKd(world.state, hit) == glm::vec3(0.25f));
}
