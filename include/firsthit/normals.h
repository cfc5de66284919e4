// normals.h - vertex normals of positions that the caller moved.
#pragma once

#include <firsthit/scene.h>

namespace firsthit {

/// Makes the normals of a world again from its positions, for those who changed World::position after
/// pose(). A vertex gets the mean of the normals of all triangles that use it (Scene::index), with the
/// weights that loading gives them: so it is flat where a triangle has vertices of its own, as
/// scene_from_arrays makes them without normals, and smooth where triangles share vertices. A
/// triangle without area, or with a corner that is not finite, adds nothing; where there is no other the
/// normal is +z.
///
/// threads  0: one for each core. The result is the same for any number, to the bit
/// throws   ArgumentError: a world that was not posed, or whose number of positions has changed
///          SceneError: a triangle with a vertex that does not exist
/// limits   a vertex that was split on loading, at a crease, at a border of textures or between parts, sees
///          the triangles of its own side alone: creases stay, and such borders become visible
///          normals that a file gave are replaced
///          allocates nothing with one thread once sizes have settled; more are started in every call
///          the OpenGL engines do not see changed positions of rigid parts (Renderer)
/// source   Max 1999, "Weights for Computing Vertex Normals from Facet Normals", JGT 4(2)
void update_normals(World& world, int threads = 1);

} // namespace firsthit
