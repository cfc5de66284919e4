"""Cameras: where points appear, and that conventions are what their names say."""

import numpy as np
import pytest

import firsthit as fh

SIZE = (80, 60)
K = np.array([[70.0, 0.5, 38.0], [0, 72.0, 31.0], [0, 0, 1]])


def pose(seed=3):
    """A rigid matrix from the world to a camera that sees the origin."""
    rng = np.random.default_rng(seed)
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    if np.linalg.det(turn) < 0:
        turn[0] *= -1
    m = np.eye(4)
    m[:3, :3] = turn
    m[:3, 3] = [0.1, -0.2, 4]
    return m


def test_matrices_come_back():
    m = pose()
    for center in (0, 0.5):
        camera = fh.from_opencv(K, m, SIZE, pixel_center=center)
        assert np.allclose(fh.world_to_camera_opencv(camera), m)
        assert np.allclose(fh.intrinsics(camera, pixel_center=center), K)
        assert np.allclose(fh.camera_to_world_opencv(camera) @ m, np.eye(4))
        flip = np.diag([1.0, -1, -1, 1])
        assert np.allclose(fh.world_to_camera_opengl(camera), flip @ m)
        assert np.allclose(fh.camera_to_world_opengl(camera), np.linalg.inv(flip @ m))


@pytest.mark.parametrize("center", [0, 0.5])
def test_positions_project_to_their_pixels(center):
    m = pose()
    camera = fh.from_opencv(K, m, SIZE, pixel_center=center)
    world = fh.load("builtin:torus").pose()
    world.positions[:] *= 0.5
    frame = fh.render(world, camera, ["position", "depth", "position_camera", "item"])
    seen = frame["item"] != fh.NO_ID
    assert seen.sum() > 300
    local = frame["position"][seen] @ m[:3, :3].T + m[:3, 3]
    assert np.allclose(local, frame["position_camera"][seen], atol=1e-5)
    assert np.allclose(local[:, 2], frame["depth"][seen], atol=1e-5)
    pixel = local @ K.T
    pixel = pixel[:, :2] / pixel[:, 2:]
    j, i = np.nonzero(seen)
    assert np.abs(pixel - np.stack([i, j], 1) - center).max() < 1e-3


def test_gltf_and_look_at_agree():
    m = np.eye(4)
    m[:3, 3] = [0, 1, 4]
    a = fh.from_gltf(m, np.pi / 4, SIZE)
    b = fh.look_at((0, 1, 4), (0, 1, 0), size=SIZE)
    world = fh.load("builtin:torus").pose()
    assert fh.render(world, a, ["depth"]).hash() == fh.render(world, b, ["depth"]).hash()


@pytest.mark.parametrize("words", [
    {"K": np.eye(4)}, {"K": np.diag([0.0, 1, 1])}, {"world_to_camera": np.eye(3)},
    {"world_to_camera": np.diag([2.0, 1, 1, 1])}, {"world_to_camera": np.diag([-1.0, 1, 1, 1])}, {"pixel_center": 1},
    {"size": (0, 10)}, {"K": np.full((3, 3), np.nan)}])
def test_cameras_that_cannot_be_are_refused(words):
    given = {"K": K, "world_to_camera": pose(), "size": SIZE, **words}
    with pytest.raises(ValueError):
        camera = fh.from_opencv(**given)
        fh.render(fh.load("builtin:torus").pose(), camera, ["depth"])


def test_orthographic_cameras():
    scene = fh.Scene(np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32), [[0, 1, 2], [0, 2, 3]])
    camera = fh.ortho((0.27, 0, 2), (0.27, 0, 0), size=(80, 40), height=4)
    assert camera.orthographic_height == 4 and camera.focal is None
    frame = fh.render(scene.pose(), camera, ["depth", "distance", "position"])
    j, i = np.nonzero(np.isfinite(frame["depth"]))
    assert (i.min(), i.max() + 1, j.min(), j.max() + 1) == (27, 47, 10, 30)
    np.testing.assert_allclose(frame["depth"][j, i], 2, rtol=1e-6)
    assert (frame["distance"] == frame["depth"]).all()
    expected = 0.27 + (i + 0.5 - 40) * 0.1
    np.testing.assert_allclose(frame["position"][j, i, 0], expected, atol=1e-6)
    behind = fh.ortho((0, 0, -1), (0, 0, -2), size=(8, 8), height=4)
    assert np.isinf(fh.render(scene.pose(), behind, ["depth"])["depth"]).all()
    with pytest.raises(ValueError):
        fh.intrinsics(camera)
    with pytest.raises(ValueError, match="orthographic height"):
        fh.render(scene.pose(), fh.ortho((0, 0, 2), (0, 0, 0), size=(8, 8), height=0), ["depth"])


def test_framing_shows_all():
    world = fh.load("builtin:torus").pose()
    for view in ("iso", "front", "back", "left", "right", "top", "bottom"):
        seen = fh.render(world, fh.framing(world, view, size=SIZE), ["item"])["item"] != fh.NO_ID
        border = np.concatenate([seen[0], seen[-1], seen[:, 0], seen[:, -1]])
        assert seen.any() and not border.any(), view
    with pytest.raises(ValueError, match="accepted"):
        fh.framing(world, "behind", size=SIZE)


def test_cameras_of_files(tmp_path):
    path = tmp_path / "cameras.json"
    path.write_text('{"width":80,"height":60,"K":[[70,0,40],[0,70,30],[0,0,1]],"convention":"opengl",'
                    '"camera_to_world":[[1,0,0,0],[0,1,0,1],[0,0,1,4],[0,0,0,1]]}')
    (camera,) = fh.read_cameras(str(path))
    assert np.allclose(camera.eye, [0, 1, 4]) and (camera.width, camera.height) == (80, 60)
    (half,) = fh.read_cameras(str(path), size=(40, 30))
    assert half.focal == (35, 35)
    (tmp_path / "c").mkdir()
    (tmp_path / "c" / "cameras.txt").write_text("1 SIMPLE_PINHOLE 80 60 70 40 30\n")
    (tmp_path / "c" / "images.txt").write_text("1 1 0 0 0 0 0 4 1 a.png\n\n")
    cameras = fh.from_colmap(str(tmp_path / "c"))
    assert list(cameras) == ["a.png"] and np.allclose(cameras["a.png"].eye, [0, 0, -4])
    with pytest.raises(OSError):
        fh.read_cameras(str(tmp_path / "none.json"))
