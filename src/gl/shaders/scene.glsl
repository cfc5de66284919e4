// scene.glsl - triangles, as they are posed: see gl/scene_buffers.h.
