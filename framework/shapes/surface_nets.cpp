#include "shapes/surface_nets.h"
#include "shapes/sampled_solid.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>
#include <vector>

namespace shapes {
namespace {

    class Polygoniser {
    public:
        Polygoniser(const Solid& solid, float cellSize)
            : m_solid(solid, cellSize)
        {
        }

        Mesh run(const glm::vec3& inside)
        {
            visit(firstCell(inside));
            followSurface();
            for (const Lattice& cell : m_found) {
                if (isCut(cell))
                    addVertex(cell);
            }
            for (const Lattice& cell : m_found) {
                for (const std::size_t axis : axes)
                    addQuad(cell, axis);
            }
            return std::move(m_mesh);
        }

    private:
        SampledSolid m_solid;
        Mesh m_mesh;
        std::vector<Lattice> m_found, m_toLookAt; // cells
        std::unordered_map<uint64_t, glm::uint> m_vertexOfCell; // of all that were found; set by addVertex

        Lattice firstCell(const glm::vec3& inside)
        {
            Lattice point { glm::floor(inside / m_solid.cellSize()) };
            while (m_solid.isInside(point + unit(0)))
                ++point.x;
            return point;
        }

        void visit(const Lattice& cell)
        {
            if (!m_vertexOfCell.try_emplace(keyOf(cell)).second)
                return;
            m_found.push_back(cell);
            m_toLookAt.push_back(cell);
        }

        // Finds the cells that the surface cuts, over the faces that it cuts.
        void followSurface()
        {
            while (!m_toLookAt.empty()) {
                const Lattice cell = m_toLookAt.back();
                m_toLookAt.pop_back();
                const Corners inside = insideOf(cell);
                if (!inside.areConnected() || !inside.others().areConnected()) {
                    fillGap(cell, inside);
                    continue;
                }
                for (const std::size_t axis : axes) {
                    if (inside.cutFace(axis, 0))
                        visit(cell - unit(axis));
                    if (inside.cutFace(axis, 1))
                        visit(cell + unit(axis));
                }
            }
        }

        // Two sheets of the surface in one cell would share its vertex: the gap between them is closed where it is
        // narrowest, and the cells around are looked at again. Ends, since points only ever become inside.
        void fillGap(const Lattice& cell, const Corners& inside)
        {
            Lattice narrowest { 0 };
            float least = std::numeric_limits<float>::max();
            for (std::size_t corner = 0; corner < 8; ++corner) {
                const Lattice point = cell + cornerOffset(corner);
                if (!inside.contains(corner) && m_solid.valueAt(point) < least) {
                    least = m_solid.valueAt(point);
                    narrowest = point;
                }
            }
            m_solid.fill(narrowest);
            for (std::size_t corner = 0; corner < 8; ++corner) {
                const Lattice neighbour = narrowest - cornerOffset(corner);
                visit(neighbour);
                m_toLookAt.push_back(neighbour);
            }
        }

        Corners insideOf(const Lattice& cell)
        {
            Corners inside;
            for (std::size_t corner = 0; corner < 8; ++corner) {
                if (m_solid.isInside(cell + cornerOffset(corner)))
                    inside.add(corner);
            }
            return inside;
        }

        bool isCut(const Lattice& cell)
        {
            const Corners inside = insideOf(cell);
            return inside.some() && inside.others().some();
        }

        void addVertex(const Lattice& cell)
        {
            m_vertexOfCell[keyOf(cell)] = static_cast<glm::uint>(m_mesh.vertices.size());
            const glm::vec3 position = moveOntoSurface(cell, meanCrossing(cell));
            // Details finer than the mesh would only make its shading restless.
            const glm::vec3 normal = m_solid.solidAround(cell).gradient(position, 0.2f * m_solid.cellSize());
            m_mesh.vertices.push_back({ position, glm::normalize(normal), glm::vec2(0.0f) });
        }

        // The mean of the points where the surface cuts the cell's edges.
        glm::vec3 meanCrossing(const Lattice& cell)
        {
            glm::vec3 sum { 0.0f };
            float count = 0.0f;
            for (std::size_t corner = 0; corner < 8; ++corner) {
                for (const std::size_t axis : axes) {
                    if ((corner >> axis & 1) != 0)
                        continue;
                    const Lattice point = cell + cornerOffset(corner);
                    const float from = m_solid.valueAt(point), to = m_solid.valueAt(point + unit(axis));
                    if ((from < 0.0f) == (to < 0.0f))
                        continue;
                    sum += glm::vec3(point) + from / (from - to) * glm::vec3(unit(axis));
                    count += 1.0f;
                }
            }
            return m_solid.cellSize() * sum / count;
        }

        // One step of Newton's method, within the cell so that neighbours do not swap.
        glm::vec3 moveOntoSurface(const Lattice& cell, const glm::vec3& from)
        {
            const Solid& solid = m_solid.solidAround(cell);
            const float size = m_solid.cellSize();
            const glm::vec3 gradient = solid.gradient(from, 0.05f * size); // a step far above the values' rounding
            const glm::vec3 onSurface = from - solid.value(from) / glm::dot(gradient, gradient) * gradient;
            const glm::vec3 lower = m_solid.positionOf(cell);
            return glm::clamp(onSurface, lower + 0.1f * size, lower + 0.9f * size);
        }

        // Where the surface cuts the edge from the cell's point along the axis, the four cells around it make a quad.
        void addQuad(const Lattice& cell, std::size_t axis)
        {
            const bool leaves = m_solid.isInside(cell);
            if (leaves == m_solid.isInside(cell + unit(axis)))
                return;
            const Lattice v = unit((axis + 1) % 3), w = unit((axis + 2) % 3);
            const auto vertex = [&](const Lattice& neighbour) { return m_vertexOfCell.at(keyOf(neighbour)); };
            std::array quad { vertex(cell - v - w), vertex(cell - w), vertex(cell), vertex(cell - v) };
            if (!leaves)
                std::swap(quad[1], quad[3]);
            addTriangles(quad);
        }

        void addTriangles(const std::array<glm::uint, 4>& quad)
        {
            const auto [a, b, c, d] = quad;
            const auto apart = [&](glm::uint i, glm::uint j) {
                return glm::distance(m_mesh.vertices[i].position, m_mesh.vertices[j].position);
            };
            if (apart(a, c) <= apart(b, d)) { // the shorter diagonal makes the rounder triangles
                m_mesh.triangles.emplace_back(a, b, c);
                m_mesh.triangles.emplace_back(a, c, d);
            } else {
                m_mesh.triangles.emplace_back(a, b, d);
                m_mesh.triangles.emplace_back(b, c, d);
            }
        }
    };

    void layPictureOver(std::vector<Vertex>& vertices)
    {
        glm::vec3 lower = vertices.front().position, upper = lower;
        for (const Vertex& vertex : vertices) {
            lower = glm::min(lower, vertex.position);
            upper = glm::max(upper, vertex.position);
        }
        for (Vertex& vertex : vertices) {
            const glm::vec3 inBox = (vertex.position - lower) / (upper - lower);
            vertex.texCoord = { 1.0f - inBox.x, inBox.y }; // from -z, with y up, +x points left
        }
    }

}

Mesh polygonise(const Solid& solid, const glm::vec3& inside, float cellSize)
{
    Mesh mesh = Polygoniser(solid, cellSize).run(inside);
    layPictureOver(mesh.vertices);
    return mesh;
}

}
