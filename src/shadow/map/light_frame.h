// light_frame.h - the axes of a light's shadow maps.
//
// A frame's z axis is the direction in which a spot or directional light shines; a point light uses
// the world's axes. A point light has six faces, each a pyramid of 90 degrees around an axis:
//
//     face 2 a + 0: around +axis a      its x is axis a + 1, its y axis a + 2, cyclically
//     face 2 a + 1: around -axis a      the same x and y: mirrored, which changes no depth test
//
// All other lights have one face, number 4, around +z. The exception is a spot light whose cone is
// wider than kWidestTangent: it has six faces.
#pragma once

#include <firsthit/scene.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace firsthit {

inline constexpr int kFaces = 6;
inline constexpr int kOnlyFace = 4; // of a light with one face

/// Tangent of the largest half angle that one face covers: 63 degrees.
inline constexpr double kWidestTangent = 2;

struct LightFrame {
    bool parallel = false; // the light's rays run along z; else they start at the origin
    bool cube = false;     // six faces
    glm::dvec3 origin{0};  // world space; 0 where parallel
    glm::dmat3 axes{1};    // frame_from_world, orthonormal
    double tan2_cone = 0;  // square of the cone's tangent; 0: no cone

    bool operator==(const LightFrame&) const = default;
};

LightFrame light_frame(const Light& light);

/// Which of the frame's axes (0 to 2) a face uses as x, y and z, and whether it looks along -z.
struct FaceAxes {
    int x, y, z;
    bool backwards;
};

constexpr FaceAxes face_axes(int face)
{
    const int z = face / 2;
    return {(z + 1) % 3, (z + 2) % 3, z, face % 2 == 1};
}

/// The rotation face_from_world of a face, for points relative to the frame's origin.
glm::dmat3 face_matrix(const LightFrame& frame, int face);

} // namespace firsthit
