// mesh.cpp - the mesh statement of AFF: three index streams become one.
//
// A corner of a triangle is a position, a normal and a texture coordinate, each with a number of
// its own. Corners with the same three numbers become one vertex. In most files the three are
// equal, so each position gets one place, in the file's order, and only further combinations are
// looked up.
#include "readers/aff/facets.h"
#include "readers/aff/statements.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

namespace firsthit::aff {
namespace {

struct Corner {
    std::uint32_t position = 0;
    std::uint32_t normal = 0; // or the triangle's number, where there are no normals
    std::uint32_t uv = 0;
    bool operator==(const Corner&) const = default;
};

struct CornerHash {
    std::size_t operator()(const Corner& c) const
    {
        // Odd constants spread the three numbers over the 64 bits (from the golden ratio).
        std::uint64_t h = c.position * 0x9E3779B97F4A7C15u;
        h = (h ^ (h >> 29) ^ c.normal) * 0xBF58476D1CE4E5B9u;
        h = (h ^ (h >> 32) ^ c.uv) * 0x94D049BB133111EBu;
        return static_cast<std::size_t>(h ^ (h >> 31));
    }
};

struct Mesh {
    std::vector<glm::vec3> position;
    std::vector<glm::vec3> normal; // empty: flat
    std::vector<glm::vec2> uv;     // empty: none
    std::int32_t texture = -1;
    std::vector<std::array<Corner, 3>> triangle;
};

/// Room for `count` things of `bytes` or more each, as far as the file can hold them.
std::size_t room(const Lexer& lexer, std::uint32_t count, std::size_t bytes)
{
    return std::min<std::size_t>(count, lexer.remaining() / bytes + 1);
}

std::vector<glm::vec3> read_triples(Lexer& lexer, std::uint32_t count, const char* what)
{
    std::vector<glm::vec3> triples;
    triples.reserve(room(lexer, count, 6));
    for (std::uint32_t k = 0; k < count; ++k) triples.push_back(lexer.small_triple(what));
    return triples;
}

std::uint32_t read_index(Lexer& lexer, std::size_t triangle, const char* what, std::size_t size)
{
    const std::uint32_t index = lexer.count(what);
    if (index >= size)
        lexer.fail_scene("triangle " + std::to_string(triangle) + ": " + what + " " +
                         std::to_string(index) + " is out of range (" + std::to_string(size) +
                         " exist)");
    return index;
}

Mesh read_streams(Lexer& lexer, State& state)
{
    Mesh mesh;
    lexer.expect("vertices", "m");
    mesh.position = read_triples(lexer, lexer.count("the number of vertices"), "a vertex");
    if (lexer.peek() == "normals") {
        lexer.next();
        mesh.normal = read_triples(lexer, lexer.count("the number of normals"), "a normal");
    }
    if (lexer.peek() == "texturecoords") {
        lexer.next();
        const std::uint32_t count = lexer.count("the number of texture coordinates");
        const std::string_view texture = lexer.word("the texture's name");
        mesh.texture = state.builder.texture(lexer, texture);
        mesh.uv.reserve(room(lexer, count, 4));
        for (std::uint32_t k = 0; k < count; ++k)
            mesh.uv.push_back(lexer.small_pair("a texture coordinate"));
    }
    lexer.expect("triangles", "m");
    const std::uint32_t triangles = lexer.count("the number of triangles");
    mesh.triangle.reserve(room(lexer, triangles, 6));
    for (std::uint32_t t = 0; t < triangles; ++t) {
        std::array<Corner, 3> row;
        for (Corner& c : row) c.position = read_index(lexer, t, "vertex", mesh.position.size());
        for (Corner& c : row)
            c.normal = mesh.normal.empty() ? t : read_index(lexer, t, "normal", mesh.normal.size());
        if (!mesh.uv.empty())
            for (Corner& c : row) c.uv = read_index(lexer, t, "texture coordinate", mesh.uv.size());
        mesh.triangle.push_back(row);
    }
    return mesh;
}

/// Gives corners their vertices.
class Unifier {
  public:
    Unifier(const Mesh& mesh, Builder& builder) : mesh_(mesh), builder_(builder) {}

    /// Adds the vertices of all positions that are used, each with its first corner.
    AffMeshRange add_positions()
    {
        constexpr std::size_t kUnused = ~std::size_t(0);
        std::vector<std::size_t> first_use(mesh_.position.size(), kUnused);
        for (std::size_t k = 3 * mesh_.triangle.size(); k-- > 0;) first_use[corner(k).position] = k;
        vertex_.resize(mesh_.position.size());
        AffMeshRange range{builder_.vertices(), 0};
        for (std::size_t p = 0; p < first_use.size(); ++p) {
            if (first_use[p] == kUnused) continue;
            vertex_[p] = {corner(first_use[p]), add(first_use[p])};
            ++range.count;
        }
        return range;
    }

    /// The vertex of corner k, which is new where its position was seen only otherwise dressed.
    std::uint32_t vertex_of(std::size_t k)
    {
        const Corner& c = corner(k);
        if (vertex_[c.position].first == c) return vertex_[c.position].second;
        const auto known = others_.find(c);
        if (known != others_.end()) return known->second;
        return others_[c] = add(k);
    }

  private:
    const Corner& corner(std::size_t k) const { return mesh_.triangle[k / 3][k % 3]; }

    std::uint32_t add(std::size_t k)
    {
        const Corner& c = corner(k);
        const glm::vec3& position = mesh_.position[c.position];
        const glm::vec3 given = mesh_.normal.empty() ? glm::vec3(0) : mesh_.normal[c.normal];
        const auto& row = mesh_.triangle[k / 3];
        const std::array<glm::vec3, 3> corners = {mesh_.position[row[0].position],
            mesh_.position[row[1].position], mesh_.position[row[2].position]};
        const glm::vec3 normal = unit_or(given, flat_normal(corners));
        return mesh_.uv.empty() ? builder_.add_vertex(position, normal)
                                : builder_.add_vertex(position, normal, mesh_.uv[c.uv]);
    }

    const Mesh& mesh_;
    Builder& builder_;
    std::vector<std::pair<Corner, std::uint32_t>> vertex_; // by position
    std::unordered_map<Corner, std::uint32_t, CornerHash> others_;
};

} // namespace

void read_mesh(Lexer& lexer, State& state)
{
    const Mesh mesh = read_streams(lexer, state);
    Builder& builder = state.builder;
    builder.begin_instance(
        lexer, state.node, builder.material(state.material_name, state.material, mesh.texture));
    Unifier unifier(mesh, builder);
    const AffMeshRange range = unifier.add_positions();
    if (state.meshes) state.meshes->push_back(range);
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
        const std::uint32_t a = unifier.vertex_of(3 * t);
        const std::uint32_t b = unifier.vertex_of(3 * t + 1);
        builder.add_triangle(a, b, unifier.vertex_of(3 * t + 2));
    }
}

} // namespace firsthit::aff
