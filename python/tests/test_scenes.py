"""Scenes from files and from arrays."""

import numpy as np
import pytest

import firsthit as fh


def test_a_scene_tells_what_is_in_it(robots):
    assert robots.triangle_count == len(robots.triangles) == len(robots.triangle_instances)
    last = robots.instances[-1]
    assert last["first_triangle"] + last["triangle_count"] == robots.triangle_count
    assert robots.end > robots.begin and robots.clip == 0
    assert "robots" in repr(robots) and not robots.studio
    assert robots.triangle_instances[last["first_triangle"]] == len(robots.instances) - 1


def test_poses_differ_and_can_be_written_again(robots):
    first = np.array(robots.pose(0).positions)
    world = robots.pose(3)
    assert not np.array_equal(world.positions, first)
    positions = world.positions
    assert robots.pose(0, world=world) is world
    assert np.array_equal(positions, first)
    with pytest.raises(ValueError):
        fh.load("builtin:torus").pose(0, world=world)
    with pytest.raises(ValueError):
        robots.pose(float("nan"))
    assert np.array_equal(robots.pose(5, "none").positions, robots.pose(0, "none").positions)
    for clip in ("no such clip", 7, -1):
        with pytest.raises(ValueError, match="clip"):
            robots.pose(0, clip)


def test_errors_say_what_and_are_of_pythons_kinds(tmp_path):
    with pytest.raises(OSError, match="nothing.stl"):
        fh.load(str(tmp_path / "nothing.stl"))
    broken = tmp_path / "broken.obj"
    broken.write_text("v 0 0 0\nf 1 2 3\n")
    with pytest.raises(fh.SceneError, match="broken.obj:2"):
        fh.load(str(broken))
    with pytest.raises(fh.Error):
        fh.load("builtin:unicorn")
    assert issubclass(fh.ArgumentError, ValueError) and issubclass(fh.SceneError, fh.Error)


def test_what_is_left_out_is_warned_of(tmp_path):
    path = tmp_path / "nan.obj"
    path.write_text("v 0 0 nan\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n")
    with pytest.warns(UserWarning):
        scene = fh.load(str(path))
    assert scene.triangle_count == 1 and scene.warnings
    with pytest.raises(fh.FileError):
        fh.load(str(path), strict=True)


def test_instances_of_one_mesh(front):
    builder = fh.SceneBuilder("two")
    mesh = builder.add_mesh([[-0.4, -0.4, 0], [0.4, -0.4, 0], [0, 0.4, 0]], [[0, 1, 2]])
    red = builder.add_material(fh.Material(name="red", model="unlit", color=(1, 0, 0)))
    blue = builder.add_material(fh.Material(name="blue", model="unlit", color=(0, 0, 1)))
    for name, x, material in (("left", -0.6, red), ("right", 0.6, blue)):
        matrix = np.eye(4)
        matrix[0, 3] = x
        builder.add_instance(mesh, world_from_mesh=matrix, material=material, name=name)
    scene = builder.build()
    with pytest.raises(ValueError):
        builder.build()
    assert [i["name"] for i in scene.instances] == ["left", "right"] and scene.materials == ["red", "blue"]
    world = scene.pose()
    assert np.allclose(world.node_matrix(1)[:3, 3], [0.6, 0, 0])
    frame = fh.render(world, front, ["instance", "color"], aa=1)
    left, right = frame["instance"][:, :32], frame["instance"][:, 32:]
    assert set(np.unique(left)) == {0, fh.NO_ID} and set(np.unique(right)) == {1, fh.NO_ID}
    assert np.allclose(frame["color"][24, 20], [1, 0, 0]) and np.allclose(frame["color"][24, 44], [0, 0, 1])
    with pytest.raises(fh.SceneError):
        other = fh.SceneBuilder()
        other.add_instance(3, material=0)
        other.build()


def test_a_texture_is_seen_the_right_way_up(front):
    picture = np.zeros((2, 2, 3), np.uint8)
    picture[0, :, 0] = 255  # red above
    picture[1, :, 2] = 255  # blue below
    square = fh.Scene([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]],
                      uv=[[0, 0], [1, 0], [1, 1], [0, 1]],
                      material=fh.Material(model="unlit", color=(1, 1, 1), texture=picture))
    color = fh.render(square.pose(), front, aa=1)["color"]
    assert color[15, 32, 0] > 0.9 and color[15, 32, 2] < 0.1
    assert color[33, 32, 2] > 0.9 and color[33, 32, 0] < 0.1
    with pytest.raises(ValueError, match="texture"):
        fh.Material(texture=np.zeros((2, 2), np.uint8))


@pytest.mark.parametrize("words", [{"model": "gold"}, {"alpha": "maybe"}])
def test_materials_that_there_are_not(words):
    with pytest.raises(ValueError, match="accepted"):
        fh.Material(**words)


def test_materials_out_of_range_are_refused():
    for words in ({"opacity": 2}, {"model": "metallic_roughness", "roughness": -1}, {"color": (float("nan"), 0, 0)}):
        with pytest.raises(ValueError):
            fh.Scene([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], material=fh.Material(**words))
