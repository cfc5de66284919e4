// pose_layout.glsl - the structs that pose.comp reads, as they lie in storage blocks: see
// layouts.glsl.

// What moves a node's vertices: rows of matrices, as VertexMatrix (scene/animate/pose_kernel.h).
FIRSTHIT_STRUCT(MatrixData)
    FIRSTHIT_ARRAY(vec4, world, 3)  // rows of world_from_node
    FIRSTHIT_ARRAY(vec4, normal, 3) // rows of the normals' matrix; w is unused
FIRSTHIT_END(MatrixData)

// Where the vertices of a scene instance come from.
FIRSTHIT_STRUCT(InstanceData)
    FIRSTHIT_FIELD(uint, matrix, 0) // number of its node's MatrixData
    FIRSTHIT_FIELD(uint, moving, 0) // 1: its vertices are in the moving arrays, in world space
    FIRSTHIT_FIELD(uint, first, 0)  // number of its first vertex in the moving arrays
    FIRSTHIT_FIELD(uint, first_vertex, 0) // in the scene
    FIRSTHIT_FIELD(uint, vertex_count, 0)
    FIRSTHIT_FIELD(uint, material, 0)
FIRSTHIT_END(InstanceData)
