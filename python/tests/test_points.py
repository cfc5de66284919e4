"""Points and lights."""

import numpy as np
import pytest

import firsthit as fh
from conftest import random_mesh


def rays_hit(origins, towards, vertices, triangles):
    """Whether each ray hits a triangle, in float64 (Möller and Trumbore 1997)."""
    hit = np.zeros(len(origins), bool)
    for a, b, c in vertices[triangles].astype(np.float64):
        e1, e2 = b - a, c - a
        p = np.cross(towards, e2)
        det = e1 @ p
        s = origins - a
        u = s @ p / det
        q = np.cross(s, e1)
        v = q @ towards / det
        t = q @ e2 / det
        hit |= (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 1e-6)
    return hit


def test_directions_are_as_rays():
    vertices, triangles = random_mesh(4, 200)
    world = fh.Scene(vertices, triangles).pose()
    points = np.random.default_rng(5).uniform(-1.2, 1.2, (400, 3)).astype(np.float32)
    directions = [[0, 0, 1], [1, 2, 0.5]]
    dark = fh.occlusion(world, points, directions=directions)
    assert dark.shape == (2, 400) and dark.dtype == bool and dark.any() and not dark.all()
    for k, d in enumerate(directions):
        wanted = rays_hit(points.astype(np.float64), np.array(d, float), vertices, triangles)
        assert (dark[k] != wanted).sum() <= 1, "a ray that passes an edge by rounding"
    bits = fh.occlusion(world, points, directions=directions, packed=True)
    assert np.array_equal(np.unpackbits(bits, axis=1, bitorder="little")[:, :400].astype(bool), dark)


def test_lights_and_receivers(square):
    world = square.pose()
    points = [[0.5, 0.2, -1], [0.5, 0.2, 1], [3, 0, -1]]
    above = fh.point((0.5, 0.2, 2))
    assert fh.occlusion(world, points, above).tolist() == [[True, False, False]]
    assert fh.occlusion(world, points, [above], receivers=[0, fh.NO_ID, fh.NO_ID]).tolist() == [[False] * 3]
    spot = fh.spot((0.5, 0.2, 2), (0, 0, -1), outer_deg=10)
    assert fh.occlusion(world, points, spot).tolist() == [[True, False, True]]
    for words in ({"receivers": [0]}, {"receivers": [5, 5, 5]}):
        with pytest.raises(ValueError):
            fh.occlusion(world, points, above, **words)
    with pytest.raises(ValueError):
        fh.occlusion(world, points)
    with pytest.raises(ValueError, match="points"):
        fh.occlusion(world, [[0, 0]], above)
    assert fh.occlusion(world, [], above).shape == (1, 0)


def test_the_sky_over_a_plane(square):
    sky = fh.Sky(64, color=(1, 1, 1), ground=(0, 0, 0), up=(0, 0, 1))
    light = fh.sky_light(square.pose(), [[0, 0, 0.5], [0, 0, -1e-3]], [[0, 0, 1], [0, 0, 1]], sky)
    assert light[0] == pytest.approx([1, 1, 1]) and (light[1] < 0.1).all()


def test_the_sun():
    azimuth, elevation, to_sun = fh.sun_position(52.5, 13.4, "2026-06-21T12:00+02:00")
    assert 120 < azimuth < 150 and 50 < elevation < 62
    assert np.linalg.norm(to_sun) == pytest.approx(1) and to_sun[1] == pytest.approx(np.sin(np.radians(elevation)))
    assert fh.sun(52.5, 13.4, "2026-06-21T01:00+02:00") is None
    assert fh.sun(52.5, 13.4, "2026-06-21T12:00+02:00", up="z").direction[2] < 0
    with pytest.raises(ValueError):
        fh.sun_position(100, 0, 0)
