// convert.h - numbers of Assimp as ours.
#pragma once

#include <assimp/types.h>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace firsthit {

inline glm::vec3 vector_of(const aiVector3D& v)
{
    return {v.x, v.y, v.z};
}

inline glm::vec3 vector_of(const aiColor3D& c)
{
    return {c.r, c.g, c.b};
}

/// Assimp's rows become columns.
inline glm::dmat4 matrix_of(const aiMatrix4x4& m)
{
    return glm::dmat4(m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4,
        m.b4, m.c4, m.d4);
}

} // namespace firsthit
