#include "debug/strokes.h"
#include <framework/variant_helper.h>

namespace debug {
namespace {

    class Pen {
    public:
        Pen(const Projection& projection, std::size_t shape)
            : m_projection(projection)
            , m_shape(shape)
        {
        }

        void line(const glm::vec3& a, const glm::vec3& b, const glm::vec3& color, float opacity = 1.0f)
        {
            if (const auto ends = m_projection.line(a, b))
                strokes.push_back({ m_shape, { ends->first, ends->second }, color, opacity, false });
        }

        void draw(const DrawnRay& r)
        {
            constexpr float longest = 100.0f; // scenes have a size of about 1
            const float length = glm::length(r.ray.direction);
            const float t = std::min(r.ray.t, length > 0.0f ? longest / length : 0.0f);
            line(r.ray.origin, r.ray.origin + t * r.ray.direction, r.color);
        }

        // Along each axis, the four edges between opposite faces.
        void draw(const DrawnBox& b)
        {
            const glm::vec3 size = b.box.upper - b.box.lower;
            for (int axis = 0; axis < 3; ++axis)
                for (int corner = 0; corner < 4; ++corner) {
                    glm::vec3 from = b.box.lower;
                    from[(axis + 1) % 3] += static_cast<float>(corner & 1) * size[(axis + 1) % 3];
                    from[(axis + 2) % 3] += static_cast<float>(corner >> 1) * size[(axis + 2) % 3];
                    glm::vec3 to = from;
                    to[axis] += size[axis];
                    line(from, to, b.color, b.transparency);
                }
        }

        void draw(const DrawnTriangle& t)
        {
            const glm::vec3 white { 1.0f };
            const glm::vec3 corners[] { t.v0.position, t.v1.position, t.v2.position };
            std::vector<glm::vec2> area;
            for (int i = 0; i < 3; ++i) {
                line(corners[i], corners[(i + 1) % 3], white);
                if (const auto corner = m_projection.point(corners[i]))
                    area.push_back(*corner);
            }
            if (area.size() == 3)
                strokes.push_back({ m_shape, std::move(area), white, 0.4f, true });
        }

        void draw(const DrawnSphere& s)
        {
            if (std::vector<glm::vec2> outline = m_projection.ball(s.center, s.radius); !outline.empty())
                strokes.push_back({ m_shape, std::move(outline), s.color, 1.0f, true });
        }

        std::vector<Stroke> strokes;

    private:
        const Projection& m_projection;
        std::size_t m_shape;
    };

}

std::vector<Stroke> strokesOf(const std::vector<Shape>& shapes, const Projection& projection)
{
    std::vector<Stroke> all;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        Pen pen { projection, i };
        std::visit([&](const auto& drawn) { pen.draw(drawn); }, shapes[i].drawn);
        all.insert(all.end(), pen.strokes.begin(), pen.strokes.end());
    }
    return all;
}

}
