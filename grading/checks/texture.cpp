#include "grading/check.h"
#include "grading/expect.h"
#include "grading/picture.h"
#include "grading/probes/numbered_texels.h"
#include <cmath>
#include <fmt/format.h>

namespace grading::texture {
namespace {

    NumberedTexels numberedTexels(Random& random, glm::ivec2 size)
    {
        return { size, { random.integer(0, 255), random.integer(0, 255), random.integer(0, 255) } };
    }

    NumberedTexels numberedTexels(Random& random)
    {
        const int width = random.integer(5, 9);
        return numberedTexels(random, { width, width + random.integer(2, 5) }); // not square: no side for the other
    }

    glm::dvec3 texel(const NumberedTexels& image, int i, int j)
    {
        const int x = std::clamp(i, 0, image.size.x - 1);
        const int y = std::clamp(j, 0, image.size.y - 1);
        return glm::dvec3(colorOf(image, y * image.size.x + x)) / 255.0;
    }

    glm::dvec3 nearestOracle(const NumberedTexels& image, const glm::dvec2& uv)
    {
        return texel(image, static_cast<int>(std::floor(uv.x * image.size.x)),
            static_cast<int>(std::floor(uv.y * image.size.y)));
    }

    glm::dvec3 bilinearOracle(const NumberedTexels& image, const glm::dvec2& uv)
    {
        const double x = uv.x * image.size.x - 0.5;
        const double y = uv.y * image.size.y - 0.5;
        const int i = static_cast<int>(std::floor(x));
        const int j = static_cast<int>(std::floor(y));
        const double fx = x - i;
        const double fy = y - j;
        return texel(image, i, j) * (1.0 - fx) * (1.0 - fy) + texel(image, i + 1, j) * fx * (1.0 - fy)
            + texel(image, i, j + 1) * (1.0 - fx) * fy + texel(image, i + 1, j + 1) * fx * fy;
    }

    struct Lookup {
        std::string probe;
        std::string function;
        glm::dvec3 (*oracle)(const NumberedTexels&, const glm::dvec2&);
    };
    const Lookup nearest { "texture.nearest", "sampleTextureNearest", nearestOracle };
    const Lookup bilinear { "texture.bilinear", "sampleTextureBilinear", bilinearOracle };

    glm::vec2 flipped(const glm::vec2& uv)
    {
        return { uv.x, 1.0f - uv.y };
    }

    // Whether all colours are those of the flipped picture: one mistake in the orientation costs the check of it alone.
    bool isFlipped(const Lookup& lookup, const NumberedTexels& image, const std::vector<glm::vec2>& coords,
        const std::vector<glm::vec3>& colors, double tolerance)
    {
        for (std::size_t i = 0; i < coords.size(); ++i) // who flips has rounded more often
            if (!(glm::length(glm::dvec3(colors[i]) - lookup.oracle(image, flipped(coords[i]))) <= 10.0 * tolerance))
                return false;
        return true;
    }

    void expectColors(const Lookup& lookup, const NumberedTexels& image, const std::vector<glm::vec2>& coords,
        const std::vector<glm::vec3>& colors, double tolerance)
    {
        for (std::size_t i = 0; i < coords.size(); ++i)
            expectNear(fmt::format("{} of {} x {} texels at {}", lookup.function, image.size.x, image.size.y,
                           toText(coords[i])),
                colors[i], lookup.oracle(image, coords[i]), tolerance);
    }

    std::vector<glm::vec3> ask(
        Exam& exam, const Lookup& lookup, const NumberedTexels& image, const std::vector<glm::vec2>& coords)
    {
        auto colors = exam.ask<std::vector<glm::vec3>>(lookup.probe, image, coords);
        expectCount(lookup.function, colors.size(), coords.size());
        return colors;
    }

    // Coordinates of up to 14 texels are rounded by 1e-6 texels, colours of neighbours differ by up to 1.
    void compare(Exam& exam, const Lookup& lookup, const NumberedTexels& image, const std::vector<glm::vec2>& coords,
        double tolerance = fewRoundings)
    {
        const std::vector<glm::vec3> colors = ask(exam, lookup, image, coords);
        if (!isFlipped(lookup, image, coords, colors, tolerance))
            expectColors(lookup, image, coords, colors, tolerance);
    }

    // Coordinates in the image, none closer than a twentieth of a texel to where a texel begins or has its centre:
    // there rounding decides.
    std::vector<glm::vec2> insideOf(Random& random, const NumberedTexels& image, int count)
    {
        std::vector<glm::vec2> coords;
        for (int i = 0; i < count; ++i) {
            const glm::vec2 quarter { random.integer(0, 2 * image.size.x - 1),
                random.integer(0, 2 * image.size.y - 1) };
            coords.push_back((quarter * 0.5f + random.vec2(0.05f, 0.45f)) / glm::vec2(image.size));
        }
        return coords;
    }

    void compareInside(Exam& exam, const Lookup& lookup)
    {
        const NumberedTexels image = numberedTexels(exam.random);
        compare(exam, lookup, image, insideOf(exam.random, image, 200));
    }

    // On the edges, 0 and 1 themselves, and within the outermost half texel.
    void compareBorder(Exam& exam, const Lookup& lookup)
    {
        const NumberedTexels image = numberedTexels(exam.random);
        std::vector<glm::vec2> coords { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } };
        for (glm::vec2 uv : insideOf(exam.random, image, 40)) {
            const int axis = exam.random.integer(0, 1);
            const float size = static_cast<float>(axis == 0 ? image.size.x : image.size.y);
            const float offset = exam.random.integer(0, 1) == 0 ? 0.0f : exam.random.uniform(0.05f, 0.45f) / size;
            uv[axis] = exam.random.integer(0, 1) == 0 ? offset : 1.0f - offset;
            coords.push_back(uv);
        }
        compare(exam, lookup, image, coords);
    }

    // Below 0 and above 1, near and far.
    void compareOutside(Exam& exam, const Lookup& lookup)
    {
        const NumberedTexels image = numberedTexels(exam.random);
        std::vector<glm::vec2> coords;
        for (glm::vec2 uv : insideOf(exam.random, image, 60)) {
            const float distance = std::pow(10.0f, exam.random.uniform(-1.0f, 2.0f));
            const int axis = exam.random.integer(0, 1);
            uv[axis] = exam.random.integer(0, 1) == 0 ? -distance : 1.0f + distance;
            coords.push_back(uv);
        }
        compare(exam, lookup, image, coords);
    }

    // The last texels' indices have outgrown a float: there are more than 2^24, of one channel to keep them small.
    NumberedTexels hugeImage(Random& random)
    {
        return { { random.integer(4100, 4200), 4200 }, glm::ivec3(random.integer(0, 255)), 1 };
    }

    // In the last rows and, as a picture may be upside down, in the first; in the last columns as often as elsewhere.
    std::vector<glm::vec2> outermostRowsOf(Random& random, const NumberedTexels& image)
    {
        std::vector<glm::vec2> coords;
        for (int i = 0; i < 80; ++i) {
            const int column = image.size.x - random.integer(1, i % 2 == 0 ? 8 : image.size.x);
            const int row = random.integer(0, 7);
            const glm::vec2 texel { column, i % 4 < 2 ? row : image.size.y - 1 - row };
            coords.push_back((texel + random.vec2(0.1f, 0.4f)) / glm::vec2(image.size));
        }
        return coords;
    }

    void compareHuge(Exam& exam)
    {
        const NumberedTexels image = hugeImage(exam.random);
        const std::vector<glm::vec2> coords = outermostRowsOf(exam.random, image);
        compare(exam, nearest, image, coords);
        // A coordinate of 4200 texels is rounded by 2.4e-4 when multiplied and again when half a texel is taken, and
        // colours in both directions differ by up to 1.
        compare(exam, bilinear, image, coords, 2e-3);
    }

    // Single texels, rows and columns: there is no neighbour to look up.
    void compareSlim(Exam& exam)
    {
        const int length = exam.random.integer(3, 9);
        for (const glm::ivec2 size : { glm::ivec2(1, 1), glm::ivec2(length, 1), glm::ivec2(1, length) }) {
            const NumberedTexels image = numberedTexels(exam.random, size);
            const std::vector<glm::vec2> coords = insideOf(exam.random, image, 30);
            compare(exam, nearest, image, coords);
            compare(exam, bilinear, image, coords);
        }
    }

    void compareOrientation(Exam& exam, const Lookup& lookup)
    {
        const NumberedTexels image = numberedTexels(exam.random);
        const std::vector<glm::vec2> coords = insideOf(exam.random, image, 50);
        expectColors(lookup, image, coords, ask(exam, lookup, image, coords), fewRoundings);
    }

    const Check nearestInside("texture.nearest.inside", 2.0,
        "the texel is floor(texCoord * size): no half is added or taken, and size is not size - 1",
        [](Exam& exam) { compareInside(exam, nearest); });
    const Check nearestBorder("texture.nearest.border", 1.0,
        "texCoord = 1 addresses the last texel: clamp the index to size - 1, not to size",
        [](Exam& exam) { compareBorder(exam, nearest); });
    const Check nearestOutside("texture.nearest.outside", 0.5,
        "coordinates below 0 or above 1 take the edge's texel; a modulo or a missing clamp reads another row",
        [](Exam& exam) { compareOutside(exam, nearest); });
    const Check bilinearInside("texture.bilinear.inside", 2.0,
        "texel centres lie at half-integers: the weights are those of texCoord * size - 0.5",
        [](Exam& exam) { compareInside(exam, bilinear); });
    const Check bilinearBorder("texture.bilinear.border", 1.0,
        "within half a texel of the edge there is no neighbour beyond it: clamp the coordinate before the weights are "
        "taken",
        [](Exam& exam) { compareBorder(exam, bilinear); });
    const Check bilinearOutside("texture.bilinear.outside", 0.5,
        "coordinates below 0 or above 1 take the edge's texels, each axis by its own size",
        [](Exam& exam) { compareOutside(exam, bilinear); });
    const Check sizes("texture.sizes.extreme", 0.5,
        "a single row or column has no neighbours to look up; the index of a texel is an int: a float counts to 2^24 "
        "only, and where the last texel begins depends on the size",
        [](Exam& exam) {
            compareSlim(exam);
            compareHuge(exam);
        });
    const Check orientation("texture.orientation.rows", 0.5,
        "row 0 is the row that v = 0 addresses: the loader has flipped the picture already, sampling must not",
        [](Exam& exam) {
            compareOrientation(exam, nearest);
            compareOrientation(exam, bilinear);
        });

    // The texture may be upside down: the check of the orientation has taken points for that already.
    void compareEitherWayUp(Exam& exam, const std::string& scene)
    {
        const PictureQuestion picture = pictureOf(scene);
        PictureQuestion upsideDown = picture;
        upsideDown.request.scene = "grading/scenes/" + scene + "_flipped.toml";
        comparePicture(exam, picture, { picture, upsideDown });
    }

    const Check nearestPicture("texture.picture.nearest", 1.0, "see the checks of sampleTextureNearest",
        [](Exam& exam) { compareEitherWayUp(exam, "texture_nearest"); });
    const Check bilinearPicture("texture.picture.bilinear", 1.0, "see the checks of sampleTextureBilinear",
        [](Exam& exam) { compareEitherWayUp(exam, "texture_bilinear"); });

}
}
