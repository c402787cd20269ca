#include "grading/validate/folder.h"
#include "stressed.h"
#include <catch2/catch.hpp>

// Mistakes of lookups, gradients, lights, pixel rays and recursion. What a submission takes to build is longer than
// what it is asked: several mistakes are made in one, in files whose cases do not ask each other's functions.

namespace {

struct Mistake {
    std::string file, name;
    std::string found; // by cases whose names begin so
};

using Submission = std::vector<Mistake>;

const std::vector<Submission> submissions {
    {
        { "texture", "nearest without a clamp", "texture.nearest" },
        { "shading", "components taken as sorted: the last at or below, the first at or above", "gradient.sample" },
        { "light", "a shadow ray that starts on the surface", "light.visibility" },
        { "render", "stratified: i / n of integers", "camera.pixels" },
    },
    {
        { "texture", "nearest clamped to width and height", "texture.nearest" },
        { "shading", "a copy sorted, the original indexed", "gradient.sample" },
        { "light", "a shadow ray's limit as an integer", "light.visibility" },
        { "render", "stratified: jitter over the whole pixel", "camera.pixels" },
    },
    {
        { "texture", "nearest repeats the texture by a modulo", "texture.nearest" },
        { "shading", "weights swapped", "gradient.sample" },
        { "light", "a shadow ray's limit from one component", "light.visibility" },
        { "render", "stratified: jitter divided by n * n", "camera.pixels" },
    },
    {
        { "texture", "nearest adds up the index in float", "texture.nearest" },
        { "shading", "0 / 0 at a component's position", "gradient.sample" },
        { "light", "a shadow ray's limit with a scalar added inside length()", "light.visibility" },
        { "render", "uniform: shifted by half a pixel", "camera.pixels" },
    },
    {
        { "texture", "bilinear without half a texel", "texture.bilinear" },
        { "shading", "equal positions among others give 0 / 0", "gradient.sample" },
        { "light", "a shadow ray that ends 1e-2 before the light", "light.visibility" },
        { "render", "-1 to 1 forgotten", "camera.pixels" },
    },
    {
        { "texture", "bilinear between texCoord * (size - 1)", "texture.bilinear" },
        { "shading", "components at minus and plus infinity stand in for missing ends", "gradient.sample" },
        { "light", "a shadow ray that starts 1e-7 above the surface", "light.visibility" },
        { "render", "stratified: N * N rays", "camera.pixels" },
    },
    {
        { "texture", "bilinear truncates negative coordinates", "texture.bilinear" },
        { "shading", "no components crash", "gradient.sample" },
        { "light", "a shadow ray that starts 1e-2 above the surface", "light.visibility" },
        { "render", "stratified: floor of a root that is not exact", "camera.pixels" },
    },
    {
        { "texture", "bilinear takes the weights after clamping the indices", "texture.bilinear" },
        { "shading", "comparison by the length of the difference", "gradient.comparison" },
        { "light", "one layer only", "light.visibility" },
    },
    {
        { "texture", "bilinear clamps the row by the width", "texture.bilinear" },
        { "shading", "extrapolated beyond the ends", "gradient.sample" },
        { "light", "alpha in place of 1 - alpha", "light.visibility" },
    },
    {
        { "texture", "nearest rounds texCoord * (size - 1)", "texture.nearest" },
        { "shading", "position remapped to (t + 1) / 2", "gradient.sample" },
        { "light", "a segment's colour reversed alone", "light.segment" },
    },
    {
        { "texture", "nearest flips v and reads past the image at v = 0", "texture.nearest" },
        { "shading", "negative light behind the surface", "gradient.model" },
        { "light", "the light's colour squared", "light.contribution" },
    },
    {
        { "texture", "bilinear adds to the colour of the last call", "texture.bilinear" },
        { "shading", "the index runs past the end above the last component", "gradient.sample" },
        { "light", "a parallelogram's sum is divided by one sample more", "light.contribution" },
        { "recursive", "depth of the mirrored light not raised", "recursion" },
    },
    {
        { "texture", "nearest truncates texCoord * (size - 1)", "texture.nearest" },
        { "shading", "the first two components whatever their position", "gradient.sample" },
        { "light", "a shadow ray without a limit", "light.visibility" },
        { "recursive", "alpha the wrong way round", "recursion" },
    },
};

std::filesystem::path build(const Submission& submission)
{
    std::filesystem::path folder;
    for (const auto& [file, name, found] : submission) {
        const std::string& text = mistakeNamed(file, name).text;
        if (folder.empty())
            folder = changedReference(file, text);
        else
            grading::writeSource(folder / (file + ".cpp"), text);
    }
    return folder;
}

}

TEST_CASE("A mistake of light fails cases of its own function", "[stress]")
{
    const Submission submission = GENERATE(from_range(submissions));
    const auto folder = build(submission);
    for (const auto& [file, name, found] : submission) {
        INFO(file << ": " << name);
        const Stressed stressed = stress(folder, "--cases 2000 --only " + found);
        INFO(stressed.printed);
        CHECK(stressed.exitCode == 1);
        REQUIRE(!stressed.json.is_null());
        CHECK(stressed.json.at("failed") > 0);
    }
}
