// layouts.glsl - constants that C++ and shaders share, and structs in the layout of std140 and
// std430.
//
// One text for both languages: program.cpp defines the macros in GLSL, gl/scene/gpu_data.h in C++.
// The C++ compiler checks that the fields lie as std140 and std430 lay them out. A vec3 starts at a
// multiple of 16 bytes, and the scalar after it fills its last four.
//
//   FIRSTHIT_CONSTANT(type, name, value)
//   FIRSTHIT_FIELD(type, name, value)     value: initial value in C++
//   FIRSTHIT_NESTED(struct, name)
//   FIRSTHIT_ARRAY(type, name, count)     of a type of 16 bytes

FIRSTHIT_CONSTANT(int, kPointLight, 0) // Light::Kind
FIRSTHIT_CONSTANT(int, kSpotLight, 1)
FIRSTHIT_CONSTANT(int, kDirectionalLight, 2)
FIRSTHIT_CONSTANT(int, kFaces, 6) // faces of a light; see shadow/map/light_frame.h

// The alpha of a sample says where its colour comes from.
FIRSTHIT_CONSTANT(float, kHoleAlpha, 0.0)    // it has none: its triangle was not found, or its ray was not shot
FIRSTHIT_CONSTANT(float, kFilledAlpha, 0.25) // from the samples around it
FIRSTHIT_CONSTANT(float, kBackgroundAlpha, 0.5)
FIRSTHIT_CONSTANT(float, kHitAlpha, 1.0)

// C++ has this struct in exact/rays.h.
#ifndef FIRSTHIT_HAS_RAYS
#include "gl/rays_layout.glsl"
#endif

// What all samples of a section of a picture share (see GpuFrame).
FIRSTHIT_STRUCT(FrameData)
    FIRSTHIT_NESTED(Rays, rays)    // of the section's samples, in world space
    FIRSTHIT_FIELD(vec3, shear, 0) // in the camera's frame, down is (shear.x, 1, 0) and forward is (shear.y, shear.z, 1)
    FIRSTHIT_FIELD(int, lights, 0)
    FIRSTHIT_FIELD(vec3, background, 0)
    FIRSTHIT_FIELD(int, reach, 0) // neighbours on each side that are tested if an item is missed
    FIRSTHIT_FIELD(vec3, ambient, 0)
    FIRSTHIT_FIELD(float, bias, -1)   // settings.shadow_bias
    FIRSTHIT_FIELD(ivec2, size, 0)    // of the section, samples
    FIRSTHIT_FIELD(ivec2, corner, 0)  // the section's first sample, in the picture
    FIRSTHIT_FIELD(uint, triangles, 0) // number of triangles; greater items are no triangles
    FIRSTHIT_FIELD(int, filter_size, 1)      // N: N x N texels are compared
    FIRSTHIT_FIELD(ivec2, steps, 1)          // between the pixels that are shot (base/pixel_steps.h)
    FIRSTHIT_FIELD(int, environment, 0)      // 1: there is one; see shade/shade_environment.h
    FIRSTHIT_FIELD(int, environment_background, 0)
    FIRSTHIT_FIELD(float, environment_table, 0)
    FIRSTHIT_FIELD(float, environment_strength, 0)
    FIRSTHIT_FIELD(float, environment_cosine, 1)
    FIRSTHIT_FIELD(float, environment_sine, 0)
    FIRSTHIT_FIELD(int, sky, 0) // 1: there is one (firsthit/options/sky_options.h)
    FIRSTHIT_FIELD(int, unused1, 0)
    FIRSTHIT_FIELD(vec3, sky_up, 0) // unit
    FIRSTHIT_FIELD(float, unused2, 0)
    FIRSTHIT_FIELD(vec3, sky_color, 0)
    FIRSTHIT_FIELD(float, unused3, 0)
    FIRSTHIT_FIELD(vec3, sky_ground, 0)
    FIRSTHIT_FIELD(float, unused4, 0)
    FIRSTHIT_ARRAY(vec4, environment_diffuse, 9)
    FIRSTHIT_ARRAY(vec4, environment_level, 8) // side, first
FIRSTHIT_END(FrameData)

FIRSTHIT_STRUCT(LightData)
    FIRSTHIT_NESTED(Rays, to_frame)     // of (X, Y, 1) in eye space, in the axes of shadow/map/light_frame.h
    FIRSTHIT_FIELD(vec3, color, 0)
    FIRSTHIT_FIELD(int, kind, 0)
    FIRSTHIT_FIELD(vec3, position, 0)   // world space
    FIRSTHIT_FIELD(float, tan2_cone, 0) // square of the tangent of a spot's outer angle; 0: no cone
    FIRSTHIT_FIELD(vec3, to_light, 0)   // directional: unit vector towards the light
    FIRSTHIT_FIELD(int, only_face, -1)  // the face that all hits lie on; -1: there are several
    FIRSTHIT_FIELD(vec3, axis, 0)       // spot: unit vector in which the light shines
    FIRSTHIT_FIELD(float, outer, 0)     // spot: see SpotCone (hits/spot_cone.h)
    FIRSTHIT_FIELD(vec3, frame_x, 0)    // rows of frame_from_world
    FIRSTHIT_FIELD(float, inv_width, 0)
    FIRSTHIT_FIELD(vec3, frame_y, 0)
    FIRSTHIT_FIELD(int, cube, 0) // 1: six faces
    FIRSTHIT_FIELD(vec3, frame_z, 0)
    FIRSTHIT_FIELD(float, inv_range2, -1) // point, spot: see shade/shade_light.h
FIRSTHIT_END(LightData)

// One face of a light; width 0: no map.
FIRSTHIT_STRUCT(MapData)
    FIRSTHIT_NESTED(Rays, to_map)      // of (X, Y, 1) in eye space, in (texel x, texel y, depth), the first two times the depth
    FIRSTHIT_FIELD(uint, first, 0)            // index of its first texel; see shadow/map/store_depth.h
    FIRSTHIT_FIELD(int, width, 0)
    FIRSTHIT_FIELD(int, height, 0)
    FIRSTHIT_FIELD(float, reach, 0)    // of slope_bias (src/glsl/shadow_map.glsl)
    FIRSTHIT_FIELD(float, rounding, 0) // added to the bias
    FIRSTHIT_FIELD(int, unused0, 0)
    FIRSTHIT_FIELD(int, unused1, 0)
    FIRSTHIT_FIELD(int, unused2, 0)
FIRSTHIT_END(MapData)
