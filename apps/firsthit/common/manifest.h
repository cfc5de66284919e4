// manifest.h - what the ids of a scene's planes stand for, with names.
#pragma once

#include "common/json.h"

#include <firsthit/scene.h>

#include <cstdint>

namespace firsthit::cli {

/// [{name, node, material, mesh, skin, first_triangle, triangles}] in order of the plane `instance`.
Json manifest_of_instances(const Scene& scene);

/// [{name, parent}] in order of the plane `node`; parent null: the world.
Json manifest_of_nodes(const Scene& scene);

/// [{name, model, alpha}] in order of the plane `material`.
Json manifest_of_materials(const Scene& scene);

/// [{name, node, fov_y_deg}]; node null: the world.
Json manifest_of_cameras(const Scene& scene);

/// [{name, kind, node}] in order of the plane `lit`.
Json manifest_of_lights(const Scene& scene);

/// [{name, begin_s, end_s, frames, channels}]
Json manifest_of_clips(const Scene& scene);

/// {scene, none, instances, nodes, materials, lights}: the lists above, each entry with its `id` in the
/// plane of its kind and, but for lights, a `color` of its own, "#rrggbb", never black.
Json manifest_of_ids(const Scene& scene);

/// A colour for an id, to show planes of ids with: bright, and far from those of the ids around. Different
/// for all ids below 2^20 or so.
std::uint32_t color_of_id(std::uint32_t id);

} // namespace firsthit::cli
