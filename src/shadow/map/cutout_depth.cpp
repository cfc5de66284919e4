// cutout_depth.cpp - rasterises the cut-outs of one tile of a shadow map.
#include "shadow/map/cutout_depth.h"

#include "visibility/bin/triangle_box.h"

#include <cstddef>
#include <limits>

namespace firsthit {
namespace {

/// The corners of a cut-out.
struct CutoutCorners {
    Corners eye;     // in eye space, where depths are
    Corners weights; // where its weights at a hit are those in the world
};

/// A parallel pencil's eye space does not keep the weights of corners; flat corners do, as these
/// are the light's plain axes.
CutoutCorners corners_in_map(const EyeMesh& mesh, bool parallel, std::uint32_t triangle)
{
    const glm::uvec3& vertex = mesh.index[triangle];
    CutoutCorners corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = vertex[int(k)];
        corners.eye[k] = eye_corner(mesh, v);
        corners.weights[k] =
            parallel ? glm::vec3(mesh.corner[v].x, mesh.corner[v].y, 1) : corners.eye[k];
    }
    return corners;
}

void raster_cutout(const EyeMesh& mesh, bool parallel, const LatticeTile& rays,
    const TileEntry& entry, DepthTile& tile)
{
    const CutoutCorners corners = corners_in_map(mesh, parallel, entry.triangle);
    const float greatest_w =
        entry.nearest_z > 0 ? 1 / entry.nearest_z : std::numeric_limits<float>::infinity();
    Effort effort;
    for (int y = entry.y0; y <= entry.y1; ++y) {
        for (int x = entry.x0; x <= entry.x1; ++x) {
            float& stored = tile.w[std::size_t(tile.column_offset[x] + tile.row_offset[y])];
            if (greatest_w <= stored) continue;
            const glm::vec3 d = rays.direction(x, y);
            if (!is_hit(corners.eye, d, effort)) continue;
            const float w = float(1 / hit_depth(corners.eye, d));
            if (w > stored && mesh.cutouts.is_solid(entry.triangle, corners.weights, d)) stored = w;
        }
    }
}

} // namespace

void raster_cutout_depth(const EyeMesh& mesh, bool parallel, const LatticeTile& rays,
    std::span<const TileEntry> entries, DepthTile& tile)
{
    for (const TileEntry& entry : entries)
        if (mesh.cutouts.has(entry.triangle)) raster_cutout(mesh, parallel, rays, entry, tile);
}

} // namespace firsthit
