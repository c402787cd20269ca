#include "files/scene_meshes.h"
#include "files/default_material.h"
#include "files/error.h"
#include "files/obj.h"
#include "files/unit_ball.h"
#include "shapes/shapes.h"
#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace files {
namespace {

    struct Placement {
        glm::vec3 translation { 0.0f };
        glm::vec3 rotation { 0.0f }; // degrees
        float scale = 1.0f;
    };

    void place(std::span<Mesh> meshes, const Placement& placement, const Frame& frame)
    {
        const glm::mat3 rotation = glm::mat3_cast(glm::quat(glm::radians(placement.rotation)));
        for (Mesh& mesh : meshes)
            for (Vertex& vertex : mesh.vertices) {
                vertex.position = frame.point(placement.translation + rotation * (placement.scale * vertex.position));
                vertex.normal = rotation * vertex.normal;
            }
    }

    template <std::size_t N> using TexCoords = std::array<glm::vec2, N>;

    constexpr TexCoords<3> triangleTexCoords { { { 0, 0 }, { 1, 0 }, { 0, 1 } } };
    constexpr TexCoords<4> quadTexCoords { { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } };

    // A flat piece as a fan of triangles.
    template <std::size_t N>
    void appendPiece(const TableReader& table, const TomlValue& value, const TexCoords<N>& texCoords, Mesh& mesh)
    {
        const std::string expected = "an array of " + std::to_string(N) + " points";
        const TomlValue::Array& points = table.arrayOf(value, expected);
        if (points.size() != N)
            table.failFound(value, expected);
        std::array<glm::vec3, N> corners;
        for (std::size_t i = 0; i < N; ++i)
            corners[i] = table.vectorOf(points[i]);

        // The cross product of the diagonals: for a triangle, of two of its edges.
        const glm::dvec3 area = glm::cross(
            glm::dvec3(corners[2]) - glm::dvec3(corners[0]), glm::dvec3(corners[N - 1]) - glm::dvec3(corners[1]));
        if (area == glm::dvec3(0.0))
            table.fail(value.line, "found points on a line, expected an area");

        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        for (std::size_t i = 0; i < N; ++i)
            mesh.vertices.push_back({ corners[i], glm::normalize(area), texCoords[i] });
        for (uint32_t i = 2; i < N; ++i)
            mesh.triangles.emplace_back(first, first + i - 1, first + i);
    }

    template <std::size_t N>
    Mesh readPieces(
        const TableReader& table, const TomlValue& value, const TexCoords<N>& texCoords, std::string_view expected)
    {
        const TomlValue::Array& pieces = table.arrayOf(value, expected);
        if (pieces.empty())
            table.failFound(value, expected);
        Mesh mesh;
        for (const TomlValue& piece : pieces)
            appendPiece(table, piece, texCoords, mesh);
        mesh.material = defaultMaterial;
        return mesh;
    }

    Mesh makeShape(const TableReader& table, const TomlValue& value)
    {
        std::string expected;
        for (const std::string_view name : shapes::shapeNames())
            expected.append(expected.empty() ? "one of " : ", ").append(name);
        const auto* name = std::get_if<std::string>(&value.content);
        std::optional<Mesh> mesh = name ? shapes::makeShape(*name) : std::nullopt;
        if (!mesh)
            table.failFound(value, expected);
        mesh->material = defaultMaterial;
        return std::move(*mesh);
    }

    // Runs what reads a file that the scene names, and adds where it does so to what goes wrong.
    template <typename Function> auto readNamed(const TableReader& table, int line, const Function& function)
    {
        try {
            return function();
        } catch (const Error& error) {
            table.fail(line, error.what());
        }
    }

    const std::string& fileName(const TableReader& table, const TomlValue& value)
    {
        const auto* name = std::get_if<std::string>(&value.content);
        if (name == nullptr || name->empty())
            table.failFound(value, "the name of a file");
        return *name;
    }

    void appendFile(const TableReader& table, const TomlValue& value, Scene& scene, MeshSources& sources)
    {
        const auto path = table.path().parent_path() / fileName(table, value);
        readNamed(table, value.line, [&] { addObj(sources.files.take(path), scene, sources.textures); });
    }

    // Adds the mesh or, of a file, meshes.
    void appendGeometry(TableReader& table, Scene& scene, MeshSources& sources)
    {
        const TomlValue* file = table.find("file");
        const TomlValue* shape = table.find("shape");
        const TomlValue* quads = table.find("quads");
        const TomlValue* triangles = table.find("triangles");
        const int count = (file != nullptr) + (shape != nullptr) + (quads != nullptr) + (triangles != nullptr);
        if (count != 1)
            table.fail(table.line(),
                "found " + std::to_string(count) + " of file, shape, quads and triangles, expected exactly one");

        const std::size_t first = scene.meshes.size();
        if (file != nullptr)
            appendFile(table, *file, scene, sources);
        else if (shape != nullptr)
            scene.meshes.push_back(makeShape(table, *shape));
        else if (quads != nullptr)
            scene.meshes.push_back(readPieces(table, *quads, quadTexCoords, "quads, each an array of 4 points"));
        else
            scene.meshes.push_back(
                readPieces(table, *triangles, triangleTexCoords, "triangles, each an array of 3 points"));

        if (file == nullptr && shape == nullptr)
            return;
        bool normalize = true;
        table.read("normalize", normalize);
        if (normalize)
            fitIntoUnitBall(std::span(scene.meshes).subspan(first));
    }

    void readMaterial(TableReader& table, Material& material, Textures& textures)
    {
        // A kd that is given is meant to be seen, so the texture of the file goes.
        if (table.find("kd") != nullptr)
            material.kdTexture = nullptr;
        readReflectance(table, material);
        if (const TomlValue* value = table.find("texture")) {
            const auto path = table.path().parent_path() / fileName(table, *value);
            material.kdTexture = readNamed(table, value->line, [&] { return textures.load(path); });
        }
    }

}

void readReflectance(TableReader& table, Material& material)
{
    table.read("kd", material.kd, fraction);
    table.read("ks", material.ks, fraction);
    table.read("shininess", material.shininess, notNegative);
    table.read("transparency", material.transparency, fraction);
}

std::vector<std::filesystem::path> namedFiles(std::span<TableReader> tables)
{
    std::vector<std::filesystem::path> paths;
    for (TableReader& table : tables)
        if (const TomlValue* value = table.find("file"))
            if (const auto* name = std::get_if<std::string>(&value->content))
                paths.push_back(table.path().parent_path() / *name);
    return paths;
}

void readMesh(TableReader& table, const Frame& frame, Scene& scene, MeshSources& sources)
{
    const std::size_t first = scene.meshes.size();
    appendGeometry(table, scene, sources);
    const std::span<Mesh> added = std::span(scene.meshes).subspan(first);

    Placement placement;
    table.read("translate", placement.translation);
    table.read("rotate", placement.rotation);
    table.read("scale", placement.scale, positive);
    place(added, placement, frame);
    for (Mesh& mesh : added)
        readMaterial(table, mesh.material, sources.textures);
    table.finish();
}

}
