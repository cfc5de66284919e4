// normals.h - recomputes vertex normals after the caller has changed positions.
#pragma once

#include <firsthit/scene.h>

namespace firsthit {

/// Recomputes World::normal from World::position, for callers that have changed positions after
/// pose(). The normal of a vertex is the mean of the normals of all triangles that use it
/// (Scene::index), weighted as on loading. So shading is smooth where triangles share vertices, and
/// flat where each triangle has its own vertices, as scene_from_arrays makes them if no normals are
/// given. A triangle without area, or with a corner that is not finite, is ignored. A vertex with
/// no other triangles gets the normal +z.
///
/// threads  number of threads; 0: one for each core. The result has the same bits for any number
/// throws   ArgumentError: the world was not posed, or its number of positions has changed
///          SceneError: a triangle has a vertex that does not exist
/// limits   vertices that were split on loading (at creases, at seams of textures, between parts)
///          use the triangles of their own side only: creases stay, but seams and borders become
///          visible. Normals from the scene's file are replaced. With one thread, nothing is
///          allocated once sizes have settled; more threads are started in each call. The OpenGL
///          engines ignore changed positions of rigid parts (see Renderer)
/// source   Max 1999, "Weights for Computing Vertex Normals from Facet Normals", JGT 4(2)
void update_normals(World& world, int threads = 1);

} // namespace firsthit
