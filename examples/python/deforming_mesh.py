"""Pictures of a mesh that deforms: each frame's vertices are written into the world, and normals made anew.

    python3 deforming_mesh.py [FRAMES [PICTURE]]        the picture, where it is named, is of the last frame
"""

import sys
import time

import numpy as np

import firsthit as fh

frames = int(sys.argv[1]) if len(sys.argv) > 1 else 500
picture = sys.argv[2] if len(sys.argv) > 2 else None

# A sphere whose vertices are shared, which makes it smooth.
rows, columns = 96, 192
theta, phi = np.meshgrid(np.linspace(0.01, np.pi - 0.01, rows), np.linspace(0, 2 * np.pi, columns, endpoint=False), indexing="ij")
sphere = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], -1).reshape(-1, 3)
corner = np.arange(rows * columns).reshape(rows, columns)
right = np.roll(corner, -1, axis=1)
quads = np.stack([corner[:-1], right[:-1], right[1:], corner[1:]], -1).reshape(-1, 4)
triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
paint = fh.Material(color=(0.2, 0.5, 0.7), specular=(0.4, 0.4, 0.4), shininess=40)
scene = fh.Scene(sphere, triangles, normals=sphere, material=paint)

world = scene.pose()
camera = fh.look_at((2.2, 1.6, 2.2), (0, 0, 0), size=(320, 240))
renderer, frame = fh.Renderer(), None
begin = time.perf_counter()
for k in range(frames):
    wave = 1 + 0.12 * np.sin(7 * sphere[:, 1] + 2 * np.pi * k / 50) * np.sin(6 * phi.ravel())
    world.positions[:] = sphere * wave[:, None]
    world.changed()
    world.update_normals()
    frame = fh.render(world, camera, ["color", "depth"], renderer=renderer, out=frame)
seconds = time.perf_counter() - begin
if picture:
    frame.save(picture)
assert np.isfinite(frame["depth"]).mean() > 0.2
print(f"{frames} frames of {scene.triangle_count} triangles: {frames / seconds:.0f} a second")
