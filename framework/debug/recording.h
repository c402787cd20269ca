#pragma once
#include "common.h"
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

// Listens to what this thread draws while it lives; the innermost one hears it. Other threads are not heard. Keeps the
// first `capacity` shapes and counts the rest.
class Recording {
public:
    explicit Recording(std::size_t capacity = 100'000);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    [[nodiscard]] const std::vector<Drawn>& shapes() const { return m_shapes; }
    [[nodiscard]] std::size_t numDropped() const { return m_numDropped; }

    // Called by draw.h: does nothing where nobody listens.
    static void add(const Drawn& shape);
    [[nodiscard]] static bool isOpen() { return s_innermost != nullptr; }

private:
    std::size_t m_capacity;
    std::size_t m_numDropped = 0;
    std::vector<Drawn> m_shapes;
    Recording* m_outer;

    static inline thread_local Recording* s_innermost = nullptr;
};

}
