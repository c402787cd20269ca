#include "grading/stress/shapes.h"
#include "grading/stress/soup.h"
#include "grading/stress/stress.h"

namespace stress::bvh {
namespace {

    using Answers = std::vector<MetInSoup>;

    Judgement judge(const Soup& soup, const Answers& answers)
    {
        return judgeClosest(soup, answers, 16.0);
    }
    Judgement judgeExactly(const Soup& soup, const Answers& answers)
    {
        return judgeClosest(soup, answers, 0.0);
    }

    constexpr int numTriangles = 40, numRays = 64;

    // From outside, from among the triangles or along an axis, a third each; some with an end.
    Ray rayThrough(Random& random, float size)
    {
        const bool fromInside = random.integer(0, 2) == 0;
        const glm::vec3 target = size * random.vec3(-1.0f, 1.0f);
        const glm::vec3 origin = fromInside ? size * random.vec3(-1.0f, 1.0f)
                                            : size * magnitude(random, 2.0f, 100.0f) * random.direction();
        Ray ray { origin, target - origin };
        if (random.integer(0, 2) == 0) {
            const int axis = random.integer(0, 2);
            const float sign = random.integer(0, 1) == 0 ? -1.0f : 1.0f;
            ray.direction = glm::vec3(random.integer(0, 1) == 0 ? -0.0f : 0.0f);
            ray.direction[axis] = sign * magnitude(random, 1e-3f, 1e3f);
            ray.origin = target;
            ray.origin[axis] = -sign * size * random.uniform(-1.0f, 3.0f);
        }
        if (random.integer(0, 3) == 0)
            ray.t = random.uniform(0.0f, 2.0f) * size / glm::length(ray.direction);
        return ray;
    }

    template <typename MakeTriangle> Soup soupOf(Random& random, float size, const MakeTriangle& makeTriangle)
    {
        Soup soup;
        for (int i = random.integer(1, numTriangles); i > 0; --i)
            soup.triangles.push_back(makeTriangle());
        for (int i = 0; i < numRays; ++i)
            soup.rays.push_back(rayThrough(random, size));
        return soup;
    }

    Soup anywhere(Random& random)
    {
        const float size = magnitude(random, 1e-6f, 1e6f);
        return soupOf(random, size, [&] {
            const glm::vec3 center = random.vec3(-1.0f, 1.0f);
            const float extent = magnitude(random, 0.01f, 1.0f);
            const auto corner = [&] { return size * (center + extent * random.vec3(-1.0f, 1.0f)); };
            return grading::Triangle { corner(), corner(), corner() };
        });
    }

    // Points, segments and slivers among them.
    Soup degenerate(Random& random)
    {
        const float size = magnitude(random, 1e-3f, 1e3f);
        return soupOf(random, size, [&] {
            const auto corner = [&] { return size * random.vec3(-1.0f, 1.0f); };
            grading::Triangle triangle { corner(), corner(), corner() };
            const int kind = random.integer(0, 4);
            if (kind <= 1)
                triangle.v2 = triangle.v1;
            if (kind == 0)
                triangle.v1 = triangle.v2 = triangle.v0;
            if (kind == 2)
                triangle.v2 = triangle.v0 + 0.5f * (triangle.v1 - triangle.v0) + 1e-5f * corner();
            return triangle;
        });
    }

    // A few triangles many times over.
    Soup duplicated(Random& random)
    {
        std::vector<grading::Triangle> kept;
        return soupOf(random, 1.0f, [&] {
            const auto corner = [&] { return random.vec3(-1.0f, 1.0f); };
            if (kept.size() < 3)
                kept.push_back({ corner(), corner(), corner() });
            return kept[static_cast<std::size_t>(random.integer(0, 2)) % kept.size()];
        });
    }

    // All about the same centre: no plane parts them.
    Soup collapsed(Random& random)
    {
        return soupOf(random, 1.0f, [&] {
            const glm::vec3 a = random.vec3(-1.0f, 1.0f), b = random.vec3(-1.0f, 1.0f);
            return grading::Triangle { a, b, -a - b };
        });
    }

    // Of very different sizes, crowded in a corner.
    Soup crowded(Random& random)
    {
        return soupOf(random, 1.0f, [&] {
            const float extent = magnitude(random, 1e-4f, 1.0f);
            const auto corner = [&] { return glm::vec3(1.0f) - extent * random.vec3(0.0f, 2.0f); };
            return grading::Triangle { corner(), corner(), corner() };
        });
    }

    // Corners, origins and directions of small whole numbers: rays along faces of boxes, through edges and corners, and
    // in planes of triangles. Nothing is rounded.
    Soup lattice(Random& random)
    {
        const auto point = [&] {
            const int x = random.integer(-4, 4), y = random.integer(-4, 4);
            return glm::vec3(x, y, random.integer(-4, 4));
        };
        Soup soup;
        for (int i = random.integer(1, numTriangles); i > 0; --i) {
            grading::Triangle triangle { point(), point(), point() };
            if (random.integer(0, 1) == 0) { // flat
                const int axis = random.integer(0, 2);
                triangle.v1[axis] = triangle.v2[axis] = triangle.v0[axis];
            }
            soup.triangles.push_back(triangle);
        }
        while (soup.rays.size() < numRays) {
            const auto sign = [&] { return static_cast<float>(random.integer(-1, 1)); };
            const glm::vec3 direction { sign(), sign(), random.integer(0, 1) == 0 ? -0.0f : sign() };
            if (direction != glm::vec3(0.0f))
                soup.rays.push_back({ point(), direction });
        }
        return soup;
    }

    // Triangles around a corner, nearly in a plane, and rays to that corner and to the edges that end there.
    Soup fan(Random& random)
    {
        const float size = magnitude(random, 1e-6f, 1e6f);
        const Frame frame = randomFrame(random);
        const glm::vec3 hub = size * random.uniform(0.0f, 10.0f) * random.direction();
        const int numSpokes = random.integer(3, 12);
        std::vector<glm::vec3> rim;
        for (int i = 0; i < numSpokes; ++i) {
            const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(numSpokes);
            const glm::vec3 spoke = std::cos(angle) * frame.along + std::sin(angle) * frame.across;
            rim.push_back(hub + size * (spoke + random.uniform(-0.1f, 0.1f) * frame.up));
        }
        Soup soup;
        for (std::size_t i = 0; i < rim.size(); ++i)
            soup.triangles.push_back({ hub, rim[i], rim[(i + 1) % rim.size()] });
        while (soup.rays.size() < numRays) {
            const glm::vec3& end = rim[static_cast<std::size_t>(random.integer(0, numSpokes - 1))];
            const float along = random.integer(0, 1) == 0 ? 0.0f : random.uniform(0.0f, 0.5f);
            const Setting setting {
                .size = size, .distance = magnitude(random, 0.5f, 1e5f), .sine = random.uniform(0.3f, 1.0f)
            };
            soup.rays.push_back(rayTo(hub + along * (end - hub), frame, random, setting));
        }
        return soup;
    }

    const Question<Soup, Answers> closest { "stress.bvh", describe, judge };
    const Question<Soup, Answers> exact { "stress.bvh", describe, judgeExactly };
    const Question<Soup, Answers> closed { "stress.bvh", describe, judgeHits };
    const Question<Soup, Answers> closestByLibrary { "stress.library", describe, judge };
    const Question<Soup, Answers> exactByLibrary { "stress.library", describe, judgeExactly };
    const Question<Soup, Answers> closedByLibrary { "stress.library", describe, judgeHits };

    const Stress kinds[] {
        { "bvh.random", closest, randomly(4000, anywhere), numRays },
        { "bvh.degenerate", closest, randomly(4000, degenerate), numRays },
        { "bvh.duplicated", closest, randomly(4000, duplicated), numRays },
        { "bvh.collapsed", closest, randomly(4000, collapsed), numRays },
        { "bvh.crowded", closest, randomly(4000, crowded), numRays },
        { "bvh.lattice", exact, randomly(4000, lattice), numRays },
        { "bvh.shared_edge", closed, randomly(8000, fan), numRays },
        { "triangle.library.random", closestByLibrary, randomly(4000, anywhere), numRays },
        { "triangle.library.degenerate", closestByLibrary, randomly(4000, degenerate), numRays },
        { "triangle.library.crowded", closestByLibrary, randomly(4000, crowded), numRays },
        { "triangle.library.lattice", exactByLibrary, randomly(4000, lattice), numRays },
        { "triangle.library.shared_edge", closedByLibrary, randomly(16000, fan), numRays },
    };

}
}
