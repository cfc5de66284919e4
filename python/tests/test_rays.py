"""Any rays: against a loop over all triangles in float64, and the ways to ask."""

import numpy as np
import pytest

import firsthit as fh
from conftest import random_mesh


def loop(origins, directions, vertices, triangles):
    """t of each ray at each triangle, inf where it is missed: float64 (N, T) (Möller and Trumbore 1997)."""
    v = vertices[triangles].astype(np.float64)
    o, d = origins.astype(np.float64)[:, None], directions.astype(np.float64)[:, None]
    e1, e2 = v[:, 1] - v[:, 0], v[:, 2] - v[:, 0]
    p = np.cross(d, e2)
    det = (p * e1).sum(-1)
    s = o - v[:, 0]
    u = (s * p).sum(-1) / det
    q = np.cross(s, e1)
    w = (d * q).sum(-1) / det
    t = (e2 * q).sum(-1) / det
    return np.where((u >= 0) & (w >= 0) & (u + w <= 1) & (t > 0), t, np.inf)


@pytest.fixture
def rays():
    rng = np.random.default_rng(2)
    return rng.uniform(-1, 1, (600, 3)).astype(np.float32), rng.uniform(-1, 1, (600, 3)).astype(np.float32)


def test_all_answers_are_a_loops(rays):
    vertices, triangles = random_mesh(7, 300)
    scene = fh.Scene(vertices, triangles)
    world = scene.pose()
    t = loop(*rays, vertices, triangles)
    nearest = t.min(1)
    hits = fh.cast(world, *rays)
    assert {name: (a.dtype.name, a.shape) for name, a in hits.items()} == {
        "t": ("float32", (600,)), "triangle": ("uint32", (600,)), "instance": ("uint32", (600,)),
        "uv": ("float32", (600, 2)), "normal": ("float32", (600, 3))}
    seen = np.isfinite(nearest)
    assert seen.sum() > 200 and (~seen).sum() > 20
    assert np.array_equal(np.isfinite(hits["t"]), seen) and np.allclose(hits["t"][seen], nearest[seen], rtol=1e-5)
    assert np.array_equal(hits["triangle"], np.where(seen, t.argmin(1), fh.NO_ID))
    assert np.array_equal(fh.occluded(world, *rays), seen)
    assert np.array_equal(fh.count_hits(world, *rays), np.isfinite(t).sum(1))
    everything = fh.all_hits(world, *rays)
    assert np.array_equal(np.diff(everything["first"]), np.isfinite(t).sum(1))
    assert np.allclose(everything["t"], np.concatenate([np.sort(row[np.isfinite(row)]) for row in t]), rtol=1e-5)
    assert np.array_equal(everything["triangle"][everything["first"][:-1][seen]], hits["triangle"][seen])
    assert np.array_equal(everything["ray"], np.repeat(np.arange(600), np.isfinite(t).sum(1)))
    # The hit by t is the hit by u and v, and the normal is the corners'.
    v = vertices[triangles[hits["triangle"][seen]]].astype(np.float64)
    u, w = hits["uv"][seen].T[..., None]
    at = rays[0][seen] + hits["t"][seen, None] * rays[1][seen]
    assert np.allclose((1 - u - w) * v[:, 0] + u * v[:, 1] + w * v[:, 2], at, atol=1e-5)
    normal = np.cross(v[:, 1] - v[:, 0], v[:, 2] - v[:, 0])
    assert np.allclose(normal / np.linalg.norm(normal, axis=1)[:, None], hits["normal"][seen], atol=1e-6)
    again = fh.cast(scene, *rays)
    assert all(np.array_equal(again[name], hits[name]) for name in hits)


def test_shapes_are_broadcast(square):
    world = square.pose()
    directions = np.zeros((4, 5, 3))
    directions[..., 2] = -1
    hits = fh.cast(world, (0.25, 0.1, 2), directions)
    assert hits["t"].shape == (4, 5) and (hits["t"] == 2).all() and hits["normal"].shape == (4, 5, 3)
    assert fh.occluded(world, (0.25, 0.1, 2), (0, 0, -1)).shape == ()
    assert fh.count_hits(world, [[0.25, 0.1, 2], [9, 9, 9]], (0, 0, -1)).tolist() == [1, 0]
    assert fh.cast(world, np.zeros((0, 3)), (0, 0, 1))["t"].shape == (0,)
    triangle = int(hits["triangle"][0, 0])
    assert fh.occluded(world, (0.25, 0.1, 2), (0, 0, -1), skip=[triangle, 1 - triangle]).tolist() == [False, True]
    assert fh.occluded(world, (0.25, 0.1, 2), (0, 0, -1), tmax=[1, 2, 3]).tolist() == [False, True, True]
    assert fh.occluded(world, (0.25, 0.1, 2), (0, 0, -1), tmin=[1, 2, 3]).tolist() == [True, True, False]
    assert fh.occluded(world, (0.25, 0.1, 2), [[0, 0, 0], [0, 0, np.nan], [np.inf, 0, 0]]).tolist() == [False] * 3


def test_what_is_refused(square):
    world = square.pose()
    for origins, directions, words in [((0, 0), (0, 0, 1), {}), ((0, 0, 0), (0, 0, 1, 0), {}), ("abc", (0, 0, 1), {}),
                                       (np.zeros((2, 3)), np.zeros((3, 3)), {}), ((0, 0, 0), (0, 0, 1), {"skip": 2}),
                                       (np.zeros((2, 3)), (0, 0, 1), {"skip": [0, 1, 0]})]:
        with pytest.raises(ValueError):
            fh.cast(world, origins, directions, **words)


def test_the_tree_follows(square):
    world = square.pose()
    caster = fh.RayCaster(1)
    assert caster.threads == 1 and caster.updates == (0, 0)
    down = dict(origins=(0.25, 0.1, 2), directions=(0, 0, -1), caster=caster)
    assert fh.cast(world, **down)["t"] == 2 and fh.cast(world, **down)["t"] == 2
    assert caster.updates == (1, 0)
    world.positions[:, 2] = 0.5
    assert fh.cast(world, **down)["t"] == 1.5
    assert caster.updates == (1, 1)


def test_the_rays_of_a_picture(robots):
    world = robots.pose(1)
    camera = fh.scene_camera(world, size=(64, 48))
    frame = fh.render(world, camera, ["item", "distance"])
    turn = fh.camera_to_world_opencv(camera)
    x, y = np.meshgrid(np.arange(64) + 0.5 - 32, np.arange(48) + 0.5 - 24)
    directions = np.stack([x, y, np.full_like(x, fh.intrinsics(camera)[0, 0])], -1) @ turn[:3, :3].T
    hits = fh.cast(world, turn[:3, 3], directions)
    assert (hits["triangle"] != frame["item"]).mean() < 0.002, "rays are rounded, those of a picture are not"
    same = (hits["triangle"] == frame["item"]) & np.isfinite(hits["t"])
    assert same.sum() > 300
    distance = hits["t"] * np.linalg.norm(directions, axis=-1)
    assert np.allclose(distance[same], frame["distance"][same], rtol=1e-4)


def test_a_scene_is_taken_as_it_begins(robots):
    world = robots.pose(robots.begin)
    low, high = world.bounds
    rng = np.random.default_rng(3)
    origins = rng.uniform(low, high, (300, 3))
    rays = origins, rng.uniform(low, high, (300, 3)) - origins
    assert fh.occluded(world, *rays).any()
    assert np.array_equal(fh.cast(robots, *rays)["t"], fh.cast(world, *rays)["t"])
