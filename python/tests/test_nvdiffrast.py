"""nvdiffrast's conventions, by triangles whose answers are known."""

import numpy as np
import pytest

import firsthit as fh
from firsthit.compat.nvdiffrast import rasterize

H, W = 20, 30


def centres():
    """NDC of pixel centres, the bottom row first."""
    return np.meshgrid((np.arange(W) + 0.5) * 2 / W - 1, (np.arange(H) + 0.5) * 2 / H - 1)


def perspective(near=0.5, far=50.0, fov_y=0.9):
    """OpenGL's matrix for column vectors."""
    f = 1 / np.tan(fov_y / 2)
    m = np.zeros((4, 4))
    m[0, 0], m[1, 1] = f * H / W, f
    m[2, 2], m[2, 3], m[3, 2] = (far + near) / (near - far), 2 * far * near / (near - far), -1
    return m


def brute(pos, tri):
    """By exact edge functions in homogeneous coordinates, float64, for each pixel and triangle."""
    x, y = centres()
    out = np.zeros((H, W, 4))
    nearest = np.full((H, W), np.inf)
    for t, corners in enumerate(pos.astype(np.float64)[tri]):
        m = corners[:, [0, 1, 3]].T
        if abs(np.linalg.det(m)) < 1e-12:
            continue
        b = np.einsum("ij,jhw->ihw", np.linalg.inv(m), np.stack([x, y, np.ones_like(x)]))
        # b are weights over w of the point: all of one sign inside, positive where w > 0.
        inside = (b >= 0).all(0)
        b = b / np.where(inside, b.sum(0), 1)
        z, w = (np.einsum("k,khw->hw", corners[:, k], b) for k in (2, 3))
        depth = z / np.where(w == 0, 1, w)
        wins = inside & (w > 0) & (depth >= -1) & (depth <= 1) & (depth < nearest)
        nearest[wins] = depth[wins]
        out[wins] = np.stack([b[0], b[1], depth, np.full((H, W), t + 1.0)], -1)[wins]
    return out


def test_one_triangle_in_clip_space():
    # Covers the lower left half: row 0 is at the bottom.
    pos = np.array([[-1, -1, 0.25, 1], [1, -1, 0.25, 1], [-1, 1, 0.25, 1]], np.float32)
    out, db = rasterize(None, pos[None], np.array([[0, 1, 2]], np.int32), resolution=(H, W))
    assert out.shape == (1, H, W, 4) and out.dtype == np.float32 and db.shape == (1, H, W, 0)
    x, y = centres()
    seen = x + y < 0
    assert np.array_equal(out[0, ..., 3], seen)
    assert out[0, 0, 0, 3] == 1 and out[0, -1, -1, 3] == 0
    # u and v are the weights of corners 0 and 1.
    u, v = (-x - y) / 2, (x + 1) / 2
    assert np.allclose(out[0][seen][:, :3], np.stack([u, v, np.full_like(u, 0.25)], -1)[seen], atol=1e-6)
    assert (out[0][~seen] == 0).all()


def test_the_nearer_triangle_wins_in_parallel_and_in_perspective():
    quad = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    tri = np.array([[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]])
    for w in (1.0, 3.0):
        for far, near in ((0.5, -0.5), (-0.2, -0.21)):
            pos = np.concatenate([np.c_[quad * w, np.full((4, 2), [z * w, w])] for z in (far, near)])
            out, _ = rasterize(None, pos, tri, (H, W))
            assert (out[0, ..., 3] >= 3).all() and np.allclose(out[0, ..., 2], near, atol=1e-6)


@pytest.mark.parametrize("kind", ["perspective", "through the near plane", "parallel", "sheared"])
def test_many_triangles_are_those_of_edge_functions(kind):
    rng = np.random.default_rng(7)
    # Not nearer together than what float32 tells apart.
    local = np.concatenate([rng.uniform(-2, 2, (300, 2)), rng.uniform(-8, -3, (300, 1))], 1)
    matrix = perspective()
    if kind == "through the near plane":
        local[:, 2] = rng.uniform(-4, 1, 300)
    if kind == "parallel":
        matrix = np.diag([0.4, 0.4, -0.1, 1.0])
    if kind == "sheared":
        matrix = matrix + 0.05 * rng.normal(size=(4, 4))
    pos = (np.c_[local, np.ones(300)] @ matrix.T).astype(np.float32)
    tri = rng.integers(0, 300, (120, 3))
    out, _ = rasterize(None, pos, tri, resolution=(H, W))
    wanted = brute(pos, tri)
    same = out[0, ..., 3] == wanted[..., 3]
    assert (~same).sum() <= 2, "pixels whose centre lies on an edge or where triangles meet"
    assert (wanted[..., 3] > 0).sum() > 100
    assert np.allclose(out[0][same][:, :2], wanted[same][:, :2], atol=1e-4)
    assert np.allclose(out[0][same][:, 2], wanted[same][:, 2], atol=1e-5)


def test_a_batch_has_its_own_vertices():
    first = np.array([[-1, -1, 0, 1], [3, -1, 0, 1], [-1, 3, 0, 1]], np.float32)
    pos = np.stack([first, first + np.float32([4, 0, 0, 0]), first * np.float32([1, 1, 1, 1])])
    out, _ = rasterize(None, pos, [[0, 1, 2]], (H, W))
    assert (out[0, ..., 3] == 1).all() and (out[1] == 0).all() and np.array_equal(out[0], out[2])


def test_what_is_not_there_is_refused():
    pos, tri = np.zeros((3, 4)), np.array([[0, 1, 2]])
    with pytest.raises(NotImplementedError, match="ranges"):
        rasterize(None, pos, tri, (4, 4), ranges=[[0, 1]])
    for bad_pos, bad_tri in ((np.zeros((3, 3)), tri), (pos, [[0, 1, 3]]), (pos, [[0.0, 1, 2]]), (pos, [[0, 1]]),
                             (pos * np.nan, tri)):
        with pytest.raises(ValueError):
            rasterize(None, bad_pos, bad_tri, (4, 4))
    out, _ = rasterize(None, pos, tri, (4, 4))
    assert (out == 0).all(), "a triangle without area"
    assert fh.NO_ID == 0xFFFFFFFF
