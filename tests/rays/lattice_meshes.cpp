// lattice_meshes.cpp - triangles and rays with small whole coordinates.
#include "rays/lattice_meshes.h"

namespace firsthit::test {
namespace {

using glm::ivec3;
using glm::uvec3;

ivec3 draw(std::mt19937& random, int most)
{
    return {whole(random, -most, most), whole(random, -most, most), whole(random, -most, most)};
}

/// Triangles without common corners, among them flat ones and coplanar ones.
LatticeMesh soup(int triangles, int most, unsigned seed)
{
    std::mt19937 random(seed);
    LatticeMesh mesh{"soup " + std::to_string(triangles) + " of " + std::to_string(most), {}, {}};
    for (int t = 0; t < triangles; ++t) {
        for (int k = 0; k < 3; ++k) mesh.corner.push_back(draw(random, most));
        const unsigned first = unsigned(3 * t);
        mesh.triangle.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// A square of n x n squares in the plane z = 0, each of two triangles.
LatticeMesh plate(int n)
{
    LatticeMesh mesh{"plate", {}, {}};
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) mesh.corner.push_back({x - n / 2, y - n / 2, 0});
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const unsigned a = unsigned(y * (n + 1) + x), b = a + 1, c = a + unsigned(n) + 1,
                           d = c + 1;
            mesh.triangle.push_back({a, b, d});
            mesh.triangle.push_back({d, c, a});
        }
    return mesh;
}

/// Boxes inside each other, each of which has each triangle three times, in different orders of its corners.
LatticeMesh boxes()
{
    LatticeMesh mesh{"boxes", {}, {}};
    for (const int size : {1, 2, 5}) {
        const unsigned first = unsigned(mesh.corner.size());
        for (int k = 0; k < 8; ++k)
            mesh.corner.push_back(size * ivec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
        const uvec3 side[12] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
        for (const uvec3& s : side) {
            mesh.triangle.push_back(first + s);
            mesh.triangle.push_back(first + uvec3(s.y, s.z, s.x));
            mesh.triangle.push_back(first + uvec3(s.z, s.y, s.x));
        }
    }
    return mesh;
}

/// Needles around one vertex: thin triangles that share it, and an edge each.
LatticeMesh fan()
{
    LatticeMesh mesh{"fan", {{0, 0, 0}}, {}};
    for (int x = -8; x <= 8; ++x) mesh.corner.push_back({x, 8, 1});
    for (int x = -8; x <= 8; ++x) mesh.corner.push_back({8, x, -3});
    for (unsigned k = 1; k + 1 < mesh.corner.size(); ++k) mesh.triangle.push_back({0, k, k + 1});
    return mesh;
}

/// Planes at z = -3 to 3 that overlap each other and cross others in lines.
LatticeMesh sheets()
{
    LatticeMesh mesh{"sheets", {}, {}};
    const auto add = [&](ivec3 a, ivec3 b, ivec3 c) {
        const unsigned first = unsigned(mesh.corner.size());
        mesh.corner.insert(mesh.corner.end(), {a, b, c});
        mesh.triangle.push_back({first, first + 1, first + 2});
    };
    for (int z = -3; z <= 3; ++z) {
        add({-6, -6, z}, {6, -6, z}, {0, 7, z});
        add({-6, 6, z}, {6, 6, z}, {0, -7, z});
        add({-6, z, -6}, {6, z, -6}, {0, z, 7});
        add({z, -6, -6}, {z, 6, 6}, {z, 6, -6});
    }
    return mesh;
}

} // namespace

std::vector<LatticeMesh> lattice_meshes()
{
    LatticeMesh one = soup(1, 3, 1);
    one.name = "one triangle";
    one.corner = {{-2, -2, 0}, {2, -2, 0}, {0, 2, 1}};
    return {one, soup(9, 2, 2), soup(40, 3, 3), soup(60, 8, 4), plate(6), boxes(), fan(), sheets()};
}

std::vector<LatticeRay> lattice_rays(
    const LatticeMesh& mesh, std::size_t count, std::mt19937& random)
{
    std::vector<LatticeRay> rays;
    const auto vertex = [&] {
        return mesh.corner[std::size_t(whole(random, 0, int(mesh.corner.size()) - 1))];
    };
    while (rays.size() < count) {
        const uvec3 t = mesh.triangle[std::size_t(whole(random, 0, int(mesh.triangle.size()) - 1))];
        const ivec3 a = mesh.corner[t.x], b = mesh.corner[t.y], c = mesh.corner[t.z];
        const ivec3 from = draw(random, 8);
        switch (whole(random, 0, 7)) {
        case 0:
            rays.push_back({from, draw(random, 3)});
            break;
        case 1:
            rays.push_back({from, vertex() - from});
            break; // through a vertex
        case 2:
            rays.push_back({vertex(), draw(random, 2)});
            break; // from one
        case 3:
            rays.push_back({a - (b - a), b - a});
            break; // along an edge
        case 4:
            rays.push_back({a + (b - a) + (c - a), (b - a) - (c - a)});
            break; // in the plane
        case 5:
            rays.push_back({2 * from - a - b, a + b - from});
            break;
        case 6:
            rays.push_back({from, {whole(random, -1, 1), 0, whole(random, -1, 1)}});
            break;
        default:
            rays.push_back({vertex(), vertex() - from});
            break;
        }
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(rays.back().origin[axis]) > 64 ||
                std::abs(rays.back().direction[axis]) > 64)
                rays.back() = {from, draw(random, 3)};
    }
    return rays;
}

} // namespace firsthit::test
