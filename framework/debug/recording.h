#pragma once
#include "common.h"
#include "debug/cause.h"
#include <variant>
#include <vector>

namespace debug {

// What was drawn: the arguments of draw.h, as values.
struct DrawnRay {
    Ray ray;
    glm::vec3 color;
};
struct DrawnBox {
    AxisAlignedBox box;
    DrawMode mode;
    glm::vec3 color;
    float transparency;
};
struct DrawnTriangle {
    Vertex v0, v1, v2;
};
struct DrawnSphere {
    glm::vec3 center;
    float radius;
    glm::vec3 color;
};
using Drawn = std::variant<DrawnRay, DrawnBox, DrawnTriangle, DrawnSphere>;

struct Shape {
    Drawn drawn;
    Cause cause;
};

// A surface that a ray of renderRay met.
struct Hit {
    Ray ray; // up to the surface
    HitInfo hitInfo;
    Cause cause;
};

// A texture that was looked up: the image belongs to the scene.
struct Lookup {
    const Image* image;
    glm::vec2 texCoord;
    Cause cause;
};

// Listens to what this thread draws while it lives; the innermost one hears it. Other threads are not heard. Keeps the
// first `capacity` of all that and counts the rest.
class Recording {
public:
    explicit Recording(std::size_t capacity = 100'000);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    [[nodiscard]] const std::vector<Shape>& shapes() const { return m_shapes; }
    [[nodiscard]] const std::vector<Hit>& hits() const { return m_hits; }
    [[nodiscard]] const std::vector<Lookup>& lookups() const { return m_lookups; }
    [[nodiscard]] std::size_t numDropped() const { return m_numDropped; }

    // Called by draw.h and whoever knows more: these do nothing where nobody listens.
    static void add(const Drawn& shape);
    static void addHit(const Ray& ray, const HitInfo& hitInfo);
    static void addLookup(const Image& image, const glm::vec2& texCoord);
    [[nodiscard]] static bool isOpen() { return s_innermost != nullptr; }

private:
    template <typename Thing> void keep(std::vector<Thing>& things, const Thing& thing);

    std::size_t m_capacity;
    std::size_t m_numDropped = 0;
    std::vector<Shape> m_shapes;
    std::vector<Hit> m_hits;
    std::vector<Lookup> m_lookups;
    Recording* m_outer;
    Watch m_watch;

    static inline constinit thread_local Recording* s_innermost = nullptr;
};

}
