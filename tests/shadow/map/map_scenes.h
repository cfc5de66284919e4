// map_scenes.h - small worlds with lights, their shadow maps, and a simple reference of sampling.
#pragma once

#include "hits/hit_position.h"
#include "lights.h"
#include "scenes.h"
#include "shadow/map/hit_picture.h"
#include "shadow/map/sample_shadow_map.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace firsthit::test {

inline void add_quad(TestWorld& world, glm::vec3 corner, glm::vec3 along, glm::vec3 across)
{
    world.add(corner, corner + along, corner + along + across);
    world.add(corner, corner + along + across, corner + across);
}

inline void add_box(TestWorld& world, glm::vec3 low, glm::vec3 high)
{
    const glm::vec3 size = high - low;
    const glm::vec3 edge[3] = {{size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}};
    for (int a = 0; a < 3; ++a) {
        const glm::vec3 &u = edge[(a + 1) % 3], &v = edge[(a + 2) % 3];
        add_quad(world, low, u, v);
        add_quad(world, low + edge[a], u, v);
    }
}

/// A box of side 1 whose lower side is 0.5 above a floor of side 8. As seen by straight_view: y
/// points down, z ahead, and the eye is at 0.
inline TestWorld box_over_floor()
{
    TestWorld world;
    add_quad(world, {-4, 2, 2}, {8, 0, 0}, {0, 0, 8});
    add_box(world, {-0.5f, 0.5f, 5.5f}, {0.5f, 1.5f, 6.5f});
    world.finish();
    return world;
}

/// Light visibility of one tile.
struct TileVisibility {
    alignas(64) float value[kMaxTile * kMaxTile];
};

/// Makes the maps of a picture's hits, as a frame does.
inline void make_maps(const World& world, const HitPicture& picture, const Settings& settings,
    Tasks& tasks, ShadowMaps& maps)
{
    start_maps(world, tasks.threads(), maps);
    tasks.for_each(picture.tiles.size(),
        [&](std::size_t k, std::size_t worker) { add_hits(picture.tiles[k]->hits, maps, worker); });
    update_maps(world, settings, maps, tasks);
}

inline std::vector<TileVisibility> sample_all_maps(
    const ShadowMaps& maps, const World& world, const HitPicture& picture, std::size_t light = 0)
{
    std::vector<TileVisibility> visibility(picture.tiles.size());
    for (std::size_t k = 0; k < visibility.size(); ++k)
        sample_shadow_map(maps, world, picture.tiles[k]->hits, light, visibility[k].value);
    return visibility;
}

/// The depth of the first triangle that the ray from a face's origin through (x, y, 1) hits; if the
/// light is parallel, that the ray along z through (x, y) hits. Infinity if there is none.
inline double plain_depth(
    const World& world, const ShadowLight& light, int face, double x, double y)
{
    const glm::dmat3 matrix = face_matrix(light.frame, face);
    double least = std::numeric_limits<double>::infinity();
    for (const glm::uvec3& index : world.scene->index) {
        glm::dvec3 p[3];
        for (int k = 0; k < 3; ++k)
            p[k] = matrix * (glm::dvec3(world.position[index[k]]) - light.frame.origin);
        const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
        const glm::dvec3 start = light.frame.parallel ? glm::dvec3(x, y, 0) : glm::dvec3(0);
        const glm::dvec3 d = light.frame.parallel ? glm::dvec3(0, 0, 1) : glm::dvec3(x, y, 1);
        const double t = glm::dot(n, p[0] - start) / glm::dot(n, d);
        if (!(t > 0 || (light.frame.parallel && std::isfinite(t)))) continue;
        const glm::dvec3 at = start + t * d;
        bool inside = true;
        for (int k = 0; k < 3; ++k)
            inside &= glm::dot(glm::cross(p[(k + 1) % 3] - p[k], at - p[k]), n) >= 0;
        if (inside) least = std::min(least, t);
    }
    return least;
}

/// A hit in the space of its map, in double precision.
struct PlainHit {
    int face = -1;              // -1: no map covers it
    double column = 0, row = 0; // texels
    double depth = 0;           // in the face's space
    double epsilon = 0;
    bool faces_light = false; // the light is on the eye's side
};

inline PlainHit plain_hit(
    const ShadowMaps& maps, const World& world, const HitTile& hits, int x, int y, int offset)
{
    PlainHit plain;
    const ShadowLight& light = maps.light[0];
    const glm::dvec3 p(hit_position(hits.rays, float(x), float(y), hits.t[offset]));
    const glm::dvec3 in_frame = light.frame.axes * (p - light.frame.origin);
    const glm::dvec3 size = glm::abs(in_frame);
    const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
    int face = 2 * axis + (in_frame[axis] < 0 ? 1 : 0), maps_in_use = 0, last = 0;
    for (int k = 0; k < kFaces; ++k)
        if (light.map[std::size_t(k)].width() > 0) ++maps_in_use, last = k;
    if (maps_in_use == 1) face = last;
    const MapFit& fit = light.map[std::size_t(face)].source.fit;
    if (fit.width == 0) return plain;

    plain.face = face;
    const glm::dvec3 q = face_matrix(light.frame, face) * (p - light.frame.origin);
    const double scale = light.frame.parallel ? 1 : q.z;
    plain.column = (q.x / scale - fit.middle_x) / fit.texel + 0.5 * fit.width;
    plain.row = (q.y / scale - fit.middle_y) / fit.texel + 0.5 * fit.height;
    plain.depth = q.z;

    const glm::uvec3& index = world.scene->index[hits.item[offset]];
    const glm::dvec3 v0(world.position[index.x]);
    const glm::dvec3 n = glm::cross(
        glm::dvec3(world.position[index.y]) - v0, glm::dvec3(world.position[index.z]) - v0);
    const glm::dvec3 n_frame = light.frame.axes * n;
    const double to_light = light.frame.parallel ? n_frame.z : glm::dot(n, v0 - light.frame.origin);
    plain.faces_light = to_light * glm::dot(n, v0 - glm::dvec3(hits.rays.eye)) > 0;
    const double sum = std::abs(n_frame.x) + std::abs(n_frame.y) + std::abs(n_frame.z);
    plain.epsilon = maps.bias >= 0 ? maps.bias
                                   : scale * scale * sum / std::abs(to_light) * 1.5 * 0.5 *
                                         maps.filter * fit.texel;
    return plain;
}

} // namespace firsthit::test
