"""Hours of sun on the ground between houses, on one day.

    python3 sun_hours.py [PICTURE]        where it is named, a picture of the houses with the hours as the ground's colours
"""

import sys

import numpy as np

import firsthit as fh

box = np.array([[x, y, z] for x in (-1, 1) for y in (0, 2) for z in (-1, 1)], float)
sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
faces = [t for a, b, c, d in sides for t in ([a, b, c], [a, c, d])]


def houses(ground=None):
    """The houses, on a ground of vertices, triangles and colours where one is given: a World."""
    builder = fh.SceneBuilder("houses")
    house = builder.add_mesh(box, faces)
    wall = builder.add_material(fh.Material(name="wall"))
    for x, z, height in ((0, 0, 3), (5, 1, 6), (-4, -3, 2)):
        at = np.diag([1.0, height, 1, 1])
        at[:3, 3] = [x, 0, z]
        builder.add_instance(house, world_from_mesh=at, material=wall, name=f"house at {x}, {z}")
    if ground is not None:
        vertices, triangles, colors = ground
        builder.add_instance(builder.add_mesh(vertices, triangles, colors=colors), name="ground",
                             material=builder.add_material(fh.Material(model="unlit", color=(1, 1, 1))))
    return builder.build().pose()


side = 81
x, z = np.meshgrid(np.linspace(-10, 10, side), np.linspace(-10, 10, side))
points = np.stack([x, 0 * x + 0.01, z], -1).reshape(-1, 3)
step = 0.25  # hours
suns = [fh.sun_position(52.5, 13.4, f"2026-03-20T{int(h):02d}:{int(h % 1 * 60):02d}+01:00") for h in np.arange(0, 24, step)]
up = [to_sun for _, elevation, to_sun in suns if elevation > 0]
hours = (~fh.occlusion(houses(), points, directions=up)).sum(0) * step
print(f"{len(up) * step:g} hours of sun in the open, {hours.min():g} in the darkest place, {hours.mean():.2f} on average")
assert 11.5 <= hours.max() <= 12.5 and hours.min() < 6

if len(sys.argv) > 1:
    corner = np.arange(side * (side - 1)).reshape(side - 1, side)[:, :-1].reshape(-1, 1)
    triangles = np.concatenate([corner + [0, side, side + 1], corner + [0, side + 1, 1]])
    share = (hours / hours.max())[:, None]
    colors = (1 - share) * [0.02, 0.04, 0.25] + share * [1.0, 0.75, 0.2]
    world = houses((points, triangles, colors))
    camera = fh.look_at((-16, 25, -24), (0.5, 0, -1), size=(480, 360))
    fh.render(world, camera).save(sys.argv[1])
