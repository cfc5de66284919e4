"""A depth camera that drives around a mesh which moves: depth and ids, as fast as they come.

    python3 depth_camera.py [FRAMES]
"""

import sys
import time

import numpy as np

import firsthit as fh

frames = int(sys.argv[1]) if len(sys.argv) > 1 else 200
side = 185  # 2 * 185 * 185 triangles
x, y = np.meshgrid(np.linspace(-1, 1, side + 1), np.linspace(-1, 1, side + 1))
corner = np.arange(side * (side + 1)).reshape(side, side + 1)[:, :-1]
quads = np.stack([corner, corner + 1, corner + side + 2, corner + side + 1], -1).reshape(-1, 4)
vertices = np.stack([x, y, 0 * x], -1).reshape(-1, 3)
triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
# With normals, vertices stay as they are; without, each triangle would have three of its own, to be flat.
scene = fh.Scene(vertices, triangles, normals=np.tile([0.0, 0, 1], (len(vertices), 1)))

world = scene.pose()
renderer = fh.Renderer(1)
frame = None
begin = time.perf_counter()
for k in range(frames):
    angle = 2 * np.pi * k / frames
    world.positions[:, 2] = (0.1 * np.sin(8 * x + angle)).ravel()
    world.changed()
    camera = fh.look_at((2 * np.cos(angle), 2 * np.sin(angle), 1.2), (0, 0, 0), (0, 0, 1), size=(640, 480))
    frame = fh.render(world, camera, ["depth", "instance"], renderer=renderer, out=frame)
    assert np.isfinite(frame["depth"]).any()
seconds = time.perf_counter() - begin
print(f"{scene.triangle_count} triangles, 640 x 480, one thread: {frames / seconds:.0f} frames a second")
