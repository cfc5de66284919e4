"""Numbers out of range: clear errors."""

import pathlib

import numpy as np
import pytest

import firsthit as fh


@pytest.mark.parametrize("threads", [-1, 1025, 10**6, 2**31, 2**80, -2**70])
def test_threads_out_of_range_are_refused(square, front, threads):
    world = square.pose()
    for make in (lambda: fh.Renderer(threads), lambda: fh.Occlusion(threads), lambda: fh.Renderer(threads=threads),
                 lambda: world.update_normals(threads=threads), lambda: square.pose(threads=threads),
                 lambda: fh.render_batch(world, [front], ["depth"], threads=threads),
                 lambda: fh.visible(world, [front], threads=threads),
                 lambda: fh.compare(world, front, threads=threads)):
        with pytest.raises(fh.ArgumentError, match=f"threads: {threads} .*0 to 1024"):
            make()


@pytest.mark.parametrize("threads", [1.0, "2", None, [1]])
def test_threads_that_are_no_numbers_are_refused(threads):
    for kind in (fh.Renderer, fh.Occlusion):
        with pytest.raises(TypeError, match="threads.*0 to 1024"):
            kind(threads)


def test_threads_are_numbers_of_any_kind():
    for threads in (2, np.int64(2), np.uint8(2), np.array(2)):
        assert fh.Renderer(threads).threads == 2
    assert fh.Renderer().threads == fh.Renderer(0).threads >= 1
    assert fh.Renderer(1024).threads == 1024


@pytest.mark.parametrize("size", [(0, 4), (4, -1), (65537, 4), (2**31, 4), (4, 2**63), (4, 2**100)])
def test_sizes_out_of_range_are_refused(square, size):
    world = square.pose()
    for make in (lambda: fh.look_at((0, 0, 3), (0, 0, 0), size=size), lambda: fh.framing(world, size=size),
                 lambda: fh.from_opencv(np.eye(3), np.eye(4), size), lambda: fh.scene_camera(world, size=size)):
        with pytest.raises(ValueError, match="size: (width|height): .*1 to 65536"):
            make()


@pytest.mark.parametrize("size", [4, (4,), (4, 4, 4), "44", (4.0, 4.0), None, ("4", 4)])
def test_sizes_that_are_none_are_refused(size):
    with pytest.raises(TypeError, match="size"):
        fh.look_at((0, 0, 3), (0, 0, 0), size=size)


@pytest.mark.parametrize("region", [(-1, 0, 4, 4), (0, 0, 0, 4), (0, 0, 2**40, 4), (2**31, 0, 4, 4)])
def test_regions_out_of_range_are_refused(square, front, region):
    with pytest.raises(ValueError, match="region"):
        fh.render(square.pose(), front, ["depth"], region=region)


@pytest.mark.parametrize("region", [(1, 2, 3), 5, (0, 0, 1.5, 4)])
def test_regions_that_are_none_are_refused(square, front, region):
    with pytest.raises(TypeError, match="region"):
        fh.render(square.pose(), front, ["depth"], region=region)


@pytest.mark.parametrize("name", ["samples", "aa", "interleave"])
@pytest.mark.parametrize("value", [0, 17, 2**31, -2**64])
def test_settings_too_large_for_a_number_are_refused(square, front, name, value):
    with pytest.raises(ValueError, match=f"{name}: {value} .*1 to 16"):
        fh.render(square.pose(), front, ["depth"], **{name: value})


@pytest.mark.parametrize("sky", [-1, 257, 2**31, 2**70])
def test_skies_out_of_range_are_refused(square, front, sky):
    for make in (lambda: fh.Sky(sky), lambda: fh.render(square.pose(), front, sky=sky)):
        with pytest.raises(ValueError, match="directions: .*0 to 256"):
            make()
    with pytest.raises(TypeError, match="directions"):
        fh.Sky(1.5)


def test_paths_are_of_any_kind(tmp_path, square, front):
    frame = fh.render(square.pose(), front, aa=1)
    for path in (tmp_path / "a.png", str(tmp_path / "b.png"), bytes(tmp_path / "c.png")):
        frame.save(path)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes() == (tmp_path / "c.png").read_bytes()
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    assert fh.load(tmp_path / "a.obj").triangle_count == 1
    with pytest.raises(fh.ArgumentError, match="png"):
        frame.save(tmp_path / "a.bmp")
    with pytest.raises(OSError, match="nowhere"):
        frame.save(tmp_path / "nowhere" / "a.png")
    with pytest.raises(TypeError):
        fh.load(3)
    assert not (tmp_path / "a.bmp").exists() and pathlib.Path(tmp_path / "a.png").stat().st_size > 100
