// bindings.glsl - the numbers by which C++ binds what shaders declare: blocks, texture units,
// uniforms.
//
// One text for both languages: shaders include it, C++ has the same names from gl/bindings.h.
// OpenGL counts uniform blocks, storage blocks and texture units separately, so numbers may repeat.

// Uniform blocks. Lights and maps are storage blocks of the same numbers where there are many.
FIRSTHIT_CONSTANT(int, kFrameBlock, 0)
FIRSTHIT_CONSTANT(int, kLightsBlock, 1)
FIRSTHIT_CONSTANT(int, kMapsBlock, 2)

// Storage blocks of passes that have one: what the pass writes, or the samples that scatter.vert
// reads, or the bits that certify.frag reads.
FIRSTHIT_CONSTANT(int, kResultBlock, 0)
FIRSTHIT_CONSTANT(int, kGivenItemsBlock, 0)
FIRSTHIT_CONSTANT(int, kCutoutsBlock, 0)

// Storage blocks of pose.comp.
FIRSTHIT_CONSTANT(int, kPoseMatricesBlock, 0)
FIRSTHIT_CONSTANT(int, kPoseInstancesBlock, 1)
FIRSTHIT_CONSTANT(int, kPoseInstanceOfVertexBlock, 2)
FIRSTHIT_CONSTANT(int, kPoseRestPositionsBlock, 3)
FIRSTHIT_CONSTANT(int, kPoseMovingPositionsBlock, 4)
FIRSTHIT_CONSTANT(int, kPoseEyeBlock, 5)
FIRSTHIT_CONSTANT(int, kPoseRestNormalsBlock, 6)
FIRSTHIT_CONSTANT(int, kPoseMovingNormalsBlock, 7)
FIRSTHIT_CONSTANT(int, kPoseWorldBlock, 8)
FIRSTHIT_CONSTANT(int, kPoseNormalsBlock, 9)

// Texture units of two-dimensional textures.
FIRSTHIT_CONSTANT(int, kItemsUnit, 0)
FIRSTHIT_CONSTANT(int, kCertifiedDepthsUnit, 1)
FIRSTHIT_CONSTANT(int, kHitsUnit, 2)
FIRSTHIT_CONSTANT(int, kColorsUnit, 3)
FIRSTHIT_CONSTANT(int, kDepthUnit, 4)

// Texture units of buffer textures.
FIRSTHIT_CONSTANT(int, kIndexUnit, 5)
FIRSTHIT_CONSTANT(int, kEyeUnit, 6)
FIRSTHIT_CONSTANT(int, kWorldUnit, 7)
FIRSTHIT_CONSTANT(int, kNormalUnit, 8)
FIRSTHIT_CONSTANT(int, kUvUnit, 9)
FIRSTHIT_CONSTANT(int, kTriangleMaterialUnit, 10)
FIRSTHIT_CONSTANT(int, kMaterialsUnit, 11)
FIRSTHIT_CONSTANT(int, kTexturesUnit, 12)
FIRSTHIT_CONSTANT(int, kMapDepthUnit, 13)
FIRSTHIT_CONSTANT(int, kSecondUvUnit, 14)
FIRSTHIT_CONSTANT(int, kVertexColorUnit, 15)
FIRSTHIT_CONSTANT(int, kTangentUnit, 16)
FIRSTHIT_CONSTANT(int, kEnvironmentUnit, 17)

// The vertex attribute of item.vert and certify.vert.
FIRSTHIT_CONSTANT(int, kEyeAttribute, 0)

// Locations of uniforms: average.frag, plane.frag, shadow_depth.vert, store_map.comp.
FIRSTHIT_CONSTANT(int, kAverageSamples, 0)
FIRSTHIT_CONSTANT(int, kPlaneLight, 0)
FIRSTHIT_CONSTANT(int, kDrawMatrix, 0)
FIRSTHIT_CONSTANT(int, kDrawOrigin, 1)
FIRSTHIT_CONSTANT(int, kDrawOffset, 2)
FIRSTHIT_CONSTANT(int, kDrawSize, 3)
FIRSTHIT_CONSTANT(int, kDrawRange, 4)
FIRSTHIT_CONSTANT(int, kDrawParallel, 5)
FIRSTHIT_CONSTANT(int, kStoreSize, 0)
FIRSTHIT_CONSTANT(int, kStoreFirst, 1)
FIRSTHIT_CONSTANT(int, kStoreRange, 2)
FIRSTHIT_CONSTANT(int, kStoreParallel, 3)
