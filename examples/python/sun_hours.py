"""Hours of sun on the ground between houses, on one day."""

import numpy as np

import firsthit as fh

box = np.array([[x, y, z] for x in (-1, 1) for y in (0, 2) for z in (-1, 1)], float)
sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
builder = fh.SceneBuilder("houses")
house = builder.add_mesh(box, [t for a, b, c, d in sides for t in ([a, b, c], [a, c, d])])
wall = builder.add_material(fh.Material(name="wall"))
for x, z, height in ((0, 0, 3), (5, 1, 6), (-4, -3, 2)):
    at = np.diag([1.0, height, 1, 1])
    at[:3, 3] = [x, 0, z]
    builder.add_instance(house, world_from_mesh=at, material=wall, name=f"house at {x}, {z}")
world = builder.build().pose()

x, z = np.meshgrid(np.linspace(-10, 10, 81), np.linspace(-10, 10, 81))
points = np.stack([x, 0 * x + 0.01, z], -1).reshape(-1, 3)
step = 0.25  # hours
suns = [fh.sun_position(52.5, 13.4, f"2026-03-20T{int(h):02d}:{int(h % 1 * 60):02d}+01:00") for h in np.arange(0, 24, step)]
up = [to_sun for _, elevation, to_sun in suns if elevation > 0]
hours = (~fh.occlusion(world, points, directions=up)).sum(0) * step
print(f"{len(up) * step:g} hours of sun in the open, {hours.min():g} in the darkest place, {hours.mean():.2f} on average")
assert 11.5 <= hours.max() <= 12.5 and hours.min() < 6
