#include "app/rendered.h"
#include "submission/named_folder.h"
#include "submission/paths.h"
#include "submission/tree_folder.h"
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace fs = std::filesystem;
using namespace rendered;

namespace {

// A sheet of 2 n^2 triangles as an OBJ file.
fs::path writeSheet(int n)
{
    fs::create_directories(work);
    const fs::path path = work / "sheet.obj";
    std::ofstream file(path);
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x)
            file << "v " << x << ' ' << y << ' ' << (x * 7 + y * 5) % 11 << '\n';
    for (int y = 0; y < n; ++y)
        for (int x = 1; x <= n; ++x) {
            const int corner = y * (n + 1) + x, above = corner + n + 1;
            file << "f " << corner << ' ' << corner + 1 << ' ' << above << "\nf " << corner + 1 << ' ' << above + 1
                 << ' ' << above << '\n';
        }
    return path;
}

std::vector<fs::path> filesBelow(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files.push_back(entry.path());
    return files;
}

}

TEST_CASE(
    "Trees of a large mesh are kept for the next picture, which is the same, also if they are damaged", "[render]")
{
    const fs::path cache = work / "cache";
    fs::remove_all(cache);
    fs::create_directories(cache);
    fs::create_directory_symlink(fs::path(submission::buildDirectory) / "submissions", cache / "submissions");
    setenv("RAYWORK_CACHE", cache.c_str(), 1);
    const std::string sheet
        = std::string("'").append(writeSheet(224).string()).append("' --size 32x32"); // 100,352 triangles
    const auto picture = [&](const std::string& setting) {
        const fs::path file = work / "sheet.png";
        CHECK(render(sheet + " -o '" + file.string() + "' --set accel_structure=" + setting).exitCode == 0);
        return bytesOf(file);
    };
    const std::string traversed = picture("true"); // by the submission, through the tree that everybody sees
    CHECK(filesBelow(cache / "trees").size() == 1);
    const std::string library = picture("false");
    CHECK(filesBelow(cache / "trees").size() == 2);
    CHECK(picture("true") == traversed);
    CHECK(picture("false") == library);
    for (const fs::path& tree : filesBelow(cache / "trees"))
        fs::resize_file(tree, fs::file_size(tree) / 2);
    CHECK(picture("true") == traversed);
    CHECK(picture("false") == library);
    unsetenv("RAYWORK_CACHE");
}

TEST_CASE("Code of another folder sees no tree that was kept by the first", "[render]")
{
    CHECK(submission::treeFolder(submission::namedFolder("reference"))
        != submission::treeFolder(submission::namedFolder("student")));
    CHECK(submission::treeFolder("a/../a") == submission::treeFolder("a"));
}
