// layouts.glsl - what C++ hands to shaders: constants, and structs as they lie in buffers.
//
// One text in both languages: program.cpp says what its words are in GLSL, gl/scene/gpu_data.h what they
// are in C++. Fields lie as std140 and std430 have them, which C++ checks: a vec3 starts at a
// multiple of 16 bytes, and the number after it fills its last four.
//
//   FIRSTHIT_CONSTANT(type, name, value)
//   FIRSTHIT_FIELD(type, name, value)     value: that C++ begins with
//   FIRSTHIT_NESTED(struct, name)

FIRSTHIT_CONSTANT(int, kPointLight, 0) // Light::Kind
FIRSTHIT_CONSTANT(int, kSpotLight, 1)
FIRSTHIT_CONSTANT(int, kDirectionalLight, 2)
FIRSTHIT_CONSTANT(int, kFaces, 6) // of a light; see shadow/map/light_frame.h

// The alpha of a sample says where its colour is from.
FIRSTHIT_CONSTANT(float, kHoleAlpha, 0.0)    // nowhere: its triangle was not found, or it was not shot
FIRSTHIT_CONSTANT(float, kFilledAlpha, 0.25) // the colours around it
FIRSTHIT_CONSTANT(float, kBackgroundAlpha, 0.5)
FIRSTHIT_CONSTANT(float, kHitAlpha, 1.0)

// C++ has Rays already.
#ifndef FIRSTHIT_HAS_RAYS
#include "gl/rays_layout.glsl"
#endif

// What all samples of a part of a picture share.
FIRSTHIT_STRUCT(FrameData)
    FIRSTHIT_NESTED(Rays, rays)    // of the part's samples, in world space
    FIRSTHIT_FIELD(vec3, shear, 0) // in the camera's frame, down is (shear.x, 1, 0) and forward is (shear.y, shear.z, 1)
    FIRSTHIT_FIELD(int, lights, 0)
    FIRSTHIT_FIELD(vec3, background, 0)
    FIRSTHIT_FIELD(int, reach, 0) // neighbours on each side that are tried for a missed item
    FIRSTHIT_FIELD(vec3, ambient, 0)
    FIRSTHIT_FIELD(float, bias, -1)   // of maps
    FIRSTHIT_FIELD(ivec2, size, 0)    // of the part, samples
    FIRSTHIT_FIELD(ivec2, corner, 0)  // the part's first sample, in the picture
    FIRSTHIT_FIELD(uint, triangles, 0) // items from here on are none
    FIRSTHIT_FIELD(int, interleave, 1) // every so-many-th sample of a row is shot: hits/lattice.h
    FIRSTHIT_FIELD(int, interleave_shift, 0) // from row to row
    FIRSTHIT_FIELD(int, filter_size, 1)      // N: N x N texels are compared
FIRSTHIT_END(FrameData)

FIRSTHIT_STRUCT(LightData)
    FIRSTHIT_NESTED(Rays, to_frame)     // of (X, Y, 1) in eye space, in the axes of shadow/map/light_frame.h
    FIRSTHIT_FIELD(vec3, color, 0)
    FIRSTHIT_FIELD(int, kind, 0)
    FIRSTHIT_FIELD(vec3, position, 0)   // world space
    FIRSTHIT_FIELD(float, tan2_cone, 0) // square of a spot's tangent where its maps end; 0: no cone
    FIRSTHIT_FIELD(vec3, to_light, 0)   // directional: unit
    FIRSTHIT_FIELD(int, only_face, -1)  // the face of all hits; -1: each hit has its own
    FIRSTHIT_FIELD(vec3, axis, 0)       // spot: unit, the way the light goes
    FIRSTHIT_FIELD(float, outer, 0)     // spot: see hits/spot_cone.h
    FIRSTHIT_FIELD(vec3, frame_x, 0)    // rows of frame_from_world
    FIRSTHIT_FIELD(float, inv_width, 0)
    FIRSTHIT_FIELD(vec3, frame_y, 0)
    FIRSTHIT_FIELD(int, cube, 0) // six faces
    FIRSTHIT_FIELD(vec3, frame_z, 0)
    FIRSTHIT_FIELD(int, unused, 0)
FIRSTHIT_END(LightData)

// One face of a light; width 0: no map.
FIRSTHIT_STRUCT(MapData)
    FIRSTHIT_NESTED(Rays, to_map)      // of (X, Y, 1) in eye space, in (texel x, texel y, depth), the first two times the depth
    FIRSTHIT_FIELD(uint, first, 0)            // of its texels, see shadow/map/store_depth.h
    FIRSTHIT_FIELD(int, width, 0)
    FIRSTHIT_FIELD(int, height, 0)
    FIRSTHIT_FIELD(float, reach, 0)    // of slope_bias (src/glsl/shadow_map.glsl)
    FIRSTHIT_FIELD(float, rounding, 0) // added to it
    FIRSTHIT_FIELD(int, unused0, 0)
    FIRSTHIT_FIELD(int, unused1, 0)
    FIRSTHIT_FIELD(int, unused2, 0)
FIRSTHIT_END(MapData)
