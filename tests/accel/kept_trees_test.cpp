#include "accel/builder.h"
#include "accel/wide/tree.h"
#include "files/kept_arrays.h"
#include "files/temporary_folder.h"
#include "grading/worker_limits.h"
#include "shapes/shapes.h"
#include "submission/prune.h"
#include <catch2/catch.hpp>
#include <cstring>
#include <thread>

using accel::WideTree;
using files::KeptArrays;
using files_test::TemporaryFolder;

namespace fs = std::filesystem;

namespace {

std::string bytesOf(const fs::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return { std::istreambuf_iterator<char>(stream), {} };
}

void overwrite(const fs::path& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

std::vector<fs::path> filesIn(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        files.push_back(entry.path());
    return files;
}

std::vector<WideTree::Triangle> someTriangles()
{
    const Mesh mesh = *shapes::makeShape("monkey");
    std::vector<WideTree::Triangle> triangles;
    for (const glm::uvec3& t : mesh.triangles)
        triangles.push_back({ mesh.vertices[t.x].position, mesh.vertices[t.y].position, mesh.vertices[t.z].position });
    return triangles;
}

// What rays from all around find.
std::vector<uint32_t> seenIn(const WideTree& tree)
{
    std::vector<uint32_t> seen;
    for (int i = 0; i < 2000; ++i) {
        const float angle = 0.01f * static_cast<float>(i), height = 0.001f * static_cast<float>(i) - 1.0f;
        const glm::vec3 origin { 3.0f * std::cos(angle), height, 3.0f * std::sin(angle) };
        const auto hit = tree.closest({ origin, -origin });
        seen.push_back(hit ? hit->primitive : ~0u);
    }
    return seen;
}

}

TEST_CASE("Kept arrays are loaded as they were saved, under their name alone", "[kept]")
{
    const TemporaryFolder folder;
    const KeptArrays kept(folder / ".");
    const std::vector<int> numbers { 1, 2, 3 };
    const std::vector<double> none;
    kept.save("a", numbers, none, 2.5f);
    std::vector<int> loaded;
    std::vector<double> loadedNone { 1.0 };
    float single = 0.0f;
    REQUIRE(kept.load("a", loaded, loadedNone, single));
    CHECK(loaded == numbers);
    CHECK(loadedNone.empty());
    CHECK(single == 2.5f);
    CHECK(!kept.load("b", loaded, loadedNone, single));
    fs::rename(folder / "a", folder / "b"); // what another name stands for
    CHECK(!kept.load("b", loaded, loadedNone, single));
}

TEST_CASE("A kept file that is damaged anywhere, cut, lengthened or of another kind is as good as none", "[kept]")
{
    const TemporaryFolder folder;
    const KeptArrays kept(folder / ".");
    kept.save("a", std::vector<int> { 1, 2, 3 }, 2.5f);
    const std::string whole = bytesOf(folder / "a");
    std::vector<int> numbers;
    float single = 0.0f;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x40);
        overwrite(folder / "a", damaged);
        INFO(i);
        CHECK(!kept.load("a", numbers, single));
        overwrite(folder / "a", whole.substr(0, i));
        CHECK(!kept.load("a", numbers, single));
    }
    overwrite(folder / "a", whole + " ");
    CHECK(!kept.load("a", numbers, single));
    overwrite(folder / "a", whole);
    std::vector<double> others;
    CHECK(!kept.load("a", others, single));
    CHECK(kept.load("a", numbers, single));
}

TEST_CASE("Where nothing can be written nothing is kept, and nobody is stopped", "[kept]")
{
    const TemporaryFolder folder;
    KeptArrays(folder / "nowhere").save("a", std::vector<int> { 1 });
    CHECK(!fs::exists(folder / "nowhere"));
}

TEST_CASE("Many who keep the same at once leave one whole file, and readers find it whole or not at all", "[kept]")
{
    const TemporaryFolder folder;
    const KeptArrays kept(folder / ".");
    const std::vector<uint32_t> numbers(100'000, 7);
    std::atomic<int> numWrong = 0;
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i)
            threads.emplace_back([&] {
                for (int round = 0; round < 20; ++round) {
                    kept.save("a", numbers);
                    std::vector<uint32_t> loaded;
                    numWrong += !kept.load("a", loaded) || loaded != numbers;
                }
            });
    }
    CHECK(numWrong == 0);
    CHECK(filesIn(folder / ".").size() == 1);
}

TEST_CASE("A kept tree finds what the tree that was built finds, and one of other triangles is not taken", "[kept]")
{
    const TemporaryFolder folder;
    const KeptArrays kept(folder / ".");
    std::vector<WideTree::Triangle> triangles = someTriangles();
    const WideTree built(triangles);
    const std::vector<uint32_t> expected = seenIn(built);
    for (int i = 0; i < 2; ++i) { // cold, warm
        const WideTree tree = WideTree::keptIn(kept, triangles);
        CHECK(tree.numBytes() == built.numBytes());
        CHECK(seenIn(tree) == expected);
    }
    REQUIRE(filesIn(folder / ".").size() == 1);

    const fs::path file = filesIn(folder / ".")[0];
    overwrite(file, bytesOf(file).substr(0, 1000));
    CHECK(seenIn(WideTree::keptIn(kept, triangles)) == expected); // built again, and kept
    CHECK(bytesOf(file).size() > 1000);

    triangles[0][0].x += 1.0f;
    CHECK(seenIn(WideTree::keptIn(kept, triangles)) == seenIn(WideTree(triangles)));
    CHECK(filesIn(folder / ".").size() == 2);
}

TEST_CASE("No grade depends on a tree that a submission's code may have kept", "[kept]")
{
    CHECK(grading::limitsOfWorkers().treeFolder.empty());
}

TEST_CASE("Of files that are too large together those go that were not used for longest", "[kept]")
{
    const TemporaryFolder folder;
    const auto now = fs::file_time_type::clock::now();
    for (int i = 0; i < 4; ++i)
        fs::last_write_time(folder.write(std::to_string(i) + "/tree", "0123456789"), now - std::chrono::hours(i));
    submission::pruneFiles(folder / ".", 25);
    CHECK(fs::exists(folder / "1/tree"));
    CHECK(!fs::exists(folder / "2/tree"));
    CHECK(!fs::exists(folder / "3/tree"));
}
