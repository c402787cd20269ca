#include "files/bitmap.h"
#include "files/error.h"
#include "files/picture.h"
#include "temporary_folder.h"
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

using Catch::Matchers::Contains;
using files_test::TemporaryFolder;

namespace {

// The least BMP header: 24 bits a texel, nothing compressed.
std::string bmpHeader(int width, int height)
{
    const auto bytes = [](int n) {
        std::string text;
        for (int shift = 0; shift < 32; shift += 8)
            text += static_cast<char>(n >> shift & 0xff);
        return text;
    };
    return "BM" + bytes(0) + bytes(0) + bytes(54) + bytes(40) + bytes(width) + bytes(height)
        + std::string("\1\0\x18\0", 4) + std::string(24, '\0');
}

}

TEST_CASE("The bottom row of a picture comes first", "[files]")
{
    const TemporaryFolder folder;
    const auto image = files::loadPicture(folder.write("a.TGA", files_test::tinyTga()));
    REQUIRE(image->width == 2);
    REQUIRE(image->height == 2);
    CHECK(image->get_pixel(0) == glm::vec3(1, 0, 0));
    CHECK(image->get_pixel(1) == glm::vec3(0, 1, 0));
    CHECK(image->get_pixel(2) == glm::vec3(0, 0, 1));
    CHECK(image->get_pixel(3) == glm::vec3(1, 1, 1));
}

TEST_CASE("A saved bitmap reads back clamped, its rows in place", "[files]")
{
    const TemporaryFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<glm::vec3> pixels { { 0, 0.2f, 1 }, { -1, 2, 0 }, { nan, 1, nan }, { 1, 1, 1 }, { 0, 0, 0 },
        { 0, 0, 0.6f } };
    files::saveBitmap(folder / "a.bmp", { 3, 2 }, pixels);
    const auto image = files::loadPicture(folder / "a.bmp");
    REQUIRE(image->width == 3);
    REQUIRE(image->height == 2);
    const std::vector<glm::vec3> expected { { 0, 0.2f, 1 }, { 0, 1, 0 }, { 0, 1, 0 }, { 1, 1, 1 }, { 0, 0, 0 },
        { 0, 0, 0.6f } }; // 0.2 and 0.6 are 51 and 153 of 255
    for (int i = 0; i < 6; ++i)
        for (int c = 0; c < 3; ++c)
            CHECK(image->get_pixel(i)[c] == Approx(expected[static_cast<std::size_t>(i)][c]));
    CHECK_THROWS_AS(files::saveBitmap(folder / "none/a.bmp", { 3, 2 }, pixels), files::Error);
}

TEST_CASE("A picture that cannot be shown whole is refused by name", "[files]")
{
    const TemporaryFolder folder;
    const auto load = [](const std::filesystem::path& path) { (void)files::loadPicture(path); };
    CHECK_THROWS_WITH(load(folder / "no.png"), Contains("no.png: cannot be read"));
    CHECK_THROWS_WITH(load(folder.write("folder/in.png", "").parent_path()), Contains("found a folder"));
    CHECK_THROWS_WITH(load(folder.write("empty.png", "")), Contains("empty.png: found an unknown format"));
    CHECK_THROWS_WITH(load(folder.write("a.hdr", "#?RADIANCE\n")), Contains("expected a PNG, JPEG, BMP or TGA"));
    CHECK_THROWS_WITH(load(folder.write("a.tga", "GIF89a")), Contains("unknown format"));
    CHECK_THROWS_WITH(load(folder.write("a.png", "\x89PNG\r\n\x1a\nabc")), Contains("a.png: found a broken picture"));
    CHECK_THROWS_WITH(load(folder.write("cut.tga", files_test::tinyTga().substr(0, 25))), Contains("end of the file"));
    CHECK_THROWS_WITH(load(folder.write("cut.bmp", bmpHeader(9, 9) + "abc")), Contains("end of the file"));
    CHECK_THROWS_WITH(load(folder.write("big.bmp", bmpHeader(8193, 1))), Contains("found 8193x1 texels"));
}
