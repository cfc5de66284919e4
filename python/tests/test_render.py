"""Pictures: what they hold, how long they live, and that they do not depend on how they were asked for."""

import gc
import threading

import numpy as np
import pytest

import firsthit as fh
from conftest import random_mesh


def test_depth_distance_and_ids_of_a_square(square, front):
    frame = fh.render(square.pose(), front, ["depth", "distance", "item", "instance", "position", "normal"])
    seen = frame["item"] != fh.NO_ID
    assert seen.any() and not seen.all()
    assert frame["depth"].dtype == np.float32 and frame["depth"].shape == (48, 64)
    assert np.allclose(frame["depth"][seen], 3)
    assert np.isinf(frame["depth"][~seen]).all()
    j, i = np.nonzero(seen)
    f = 48 / (2 * np.tan(np.pi / 8))
    away = np.sqrt((i + 0.5 - 32) ** 2 + (j + 0.5 - 24) ** 2 + f**2) / f * 3
    assert np.allclose(frame["distance"][seen], away, rtol=1e-6)
    assert (frame["instance"][seen] == 0).all() and frame["instance"].dtype == np.uint32
    assert np.allclose(frame["position"][seen][:, 2], 0, atol=1e-6)
    assert np.allclose(frame["normal"][seen], [0, 0, 1])
    # The lower right triangle is the first.
    assert frame["item"][30, 40] == 0 and frame["item"][15, 22] == 1


def test_channels_keep_their_memory(square, front):
    depth = fh.render(square.pose(), front, ["depth"])["depth"]
    before = depth.copy()
    for _ in range(20):
        fh.render(square.pose(), front, ["depth", "normal"])
    gc.collect()
    assert np.array_equal(depth, before)
    assert not depth.flags.owndata


def test_a_frame_is_written_again(square, front):
    world = square.pose()
    frame = fh.render(world, front, ["depth"])
    address = frame["depth"].ctypes.data
    world.positions[:, 2] -= 1
    world.changed()
    again = fh.render(world, front, ["depth"], out=frame)
    assert again is frame and frame["depth"].ctypes.data == address
    assert np.nanmin(frame["depth"]) == pytest.approx(4)


def test_vertices_move_without_a_copy(square, front):
    world = square.pose()
    positions = world.positions
    positions += [0, 0, 1]
    assert np.array_equal(world.positions, positions)
    assert fh.render(world, front, ["depth"])["depth"].min() == pytest.approx(2)
    assert square.pose().positions[:, 2].max() == 0, "the scene stays as it was"
    world.normals[:] = 0
    world.update_normals()
    assert np.allclose(world.normals, [0, 0, 1])
    positions[1, 2] = np.nan
    with pytest.raises(fh.SceneError, match="vertex 1"):
        world.changed()


def test_arrays_outlive_their_world(square):
    positions = square.pose().positions
    gc.collect()
    assert positions.sum() == 0
    triangles = fh.Scene([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).triangles
    gc.collect()
    assert triangles.tolist() == [[0, 1, 2]]
    with pytest.raises(ValueError):
        triangles[0, 0] = 2


def test_a_region_is_part_of_the_picture(robots):
    world = robots.pose(2.5)
    camera = fh.scene_camera(world, size=(120, 90))
    whole = fh.render(world, camera, ["color", "depth", "item"], aa=1)
    part = fh.render(world, camera, ["color", "depth", "item"], aa=1, region=(30, 20, 50, 40))
    for name in whole.channels:
        assert np.array_equal(part[name], whole[name][20:60, 30:80]), name
    with pytest.raises(ValueError):
        fh.render(world, camera, ["depth"], region=(-1, 0, 5, 5))
    with pytest.raises(ValueError):
        fh.render(world, camera, ["depth"], region=(100, 0, 50, 5))


def test_hashes_do_not_depend_on_threads(robots):
    world = robots.pose(4)
    camera = fh.scene_camera(world, size=(100, 80))
    hashes = {fh.render(world, camera, ["color", "item", "lit", "normal"], renderer=fh.Renderer(n)).hash() for n in (1, 2, 5)}
    assert len(hashes) == 1
    assert fh.render(robots.pose(4.1), camera, ["color", "item", "lit", "normal"]).hash() not in hashes


def test_a_batch_is_its_pictures():
    vertices, triangles = random_mesh(1)
    world = fh.Scene(vertices, triangles).pose()
    cameras = fh.turntable(world, 7, size=(48, 40))
    for channels in (["depth", "instance", "item"], ["color", "lit"]):
        batch = fh.render_batch(world, cameras, channels, threads=3)
        assert [f.hash() for f in batch] == [fh.render(world, c, channels).hash() for c in cameras]
    assert fh.render_batch(world, []) == []
    with pytest.raises(fh.Error):
        fh.render_batch(world, [fh.look_at((0, 0, 3), (0, 0, 0), size=(0, 8))] * 5, ["depth"])


def test_visible_triangles_are_those_of_the_pictures():
    vertices, triangles = random_mesh(2)
    world = fh.Scene(vertices, triangles).pose()
    cameras = fh.turntable(world, 5, size=(40, 40))
    counts = np.zeros(len(triangles), np.uint64)
    for camera in cameras:
        for item in fh.render(world, camera, ["item"])["item"].ravel():
            if item != fh.NO_ID:
                counts[item] += 1
    assert np.array_equal(fh.visible(world, cameras), counts) and counts.any()


def test_motion_of_a_square_that_moves(square, front):
    before, now = square.pose(), square.pose()
    now.positions[:, 0] += 0.25
    frame = fh.render(now, front, ["motion", "motion_visible", "item"], previous=(before, front))
    seen = frame["item"] != fh.NO_ID
    pixels = 0.25 * 48 / (2 * np.tan(np.pi / 8)) / 3
    assert np.allclose(frame["motion"][seen], [pixels, 0], atol=1e-4)


def test_lights_in_the_place_of_the_scenes(square, front):
    world = square.pose()
    here = fh.render(world, front, ["color", "lit"], aa=1, sky=0, lights=[fh.point((0, 0, 2), color=(1, 0, 0))])
    assert here["lit"].shape == (48, 64, 1)
    assert here["color"][24, 32, 0] > 0.5 and here["color"][24, 32, 1] == here["color"][24, 32, 2]
    two = fh.render(world, front, ["lit"], lights=[fh.point((0, 0, 2)), fh.directional((0, 0, -1))])
    assert two["lit"].shape == (48, 64, 2)
    assert len(world.lights) == 1, "the world's lights are as before"


def test_no_channel_that_was_not_asked_for(square, front):
    frame = fh.render(square.pose(), front, ["depth"])
    assert frame.channels == ["depth"] and "depth" in frame and "item" not in frame
    with pytest.raises(KeyError, match="item"):
        frame["item"]
    with pytest.raises(ValueError, match="accepted"):
        frame["colour"]
    with pytest.raises(ValueError):
        fh.render(square.pose(), front, ["none"])


@pytest.mark.parametrize("words", [{"engine": "fast"}, {"shadows": "soft"}, {"samples": 0}, {"samples": 17}, {"aa": 99},
                                   {"samples": 2, "aa": 2}, {"sky": 1000}])
def test_settings_out_of_range_are_refused(square, front, words):
    with pytest.raises(ValueError):
        fh.render(square.pose(), front, **words)


def test_what_progress_raises_gives_the_frame_up(robots):
    world = robots.pose(1)
    camera = fh.scene_camera(world, size=(700, 700))
    shares = []
    fh.render(world, camera, progress=shares.append)
    assert shares == sorted(shares) and shares[-1] == 1

    def stop(share):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        fh.render(world, camera, progress=stop)
    assert fh.render(world, camera, ["depth"])["depth"].shape == (700, 700)


def test_threads_with_a_renderer_each_give_right_answers():
    scenes = [fh.Scene(*random_mesh(seed)) for seed in range(4)]
    camera = fh.look_at((0, 0, 4), (0, 0, 0), size=(64, 64))
    wanted = [fh.render(scene.pose(), camera, ["color", "item"]).hash() for scene in scenes]
    wrong = []

    def work(k):
        world = scenes[k].pose()
        for _ in range(10):
            if fh.render(world, camera, ["color", "item"]).hash() != wanted[k]:
                wrong.append(k)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_threads_share_a_world_and_a_renderer(robots):
    world, renderer = robots.pose(2), fh.Renderer(1)
    cameras = [fh.framing(world, view, size=(40, 40)) for view in ("front", "left", "top", "iso")]
    wanted = [fh.render(world, camera, ["color", "depth"]).hash() for camera in cameras]
    got = [None] * 4

    def work(k):
        for _ in range(5):
            got[k] = fh.render(world, cameras[k], ["color", "depth"], renderer=renderer).hash()

    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert got == wanted


def test_compare_finds_nothing_wrong(robots):
    world = robots.pose(3)
    camera = fh.scene_camera(world, size=(32, 32))
    result = fh.compare(world, camera, lit=True)
    assert result["ours_wrong"] == 0 and result["lit_ours_wrong"] == 0 and result["pixels"] == 1024
    with pytest.raises(ValueError):
        fh.compare(world, camera, against="wishes")
