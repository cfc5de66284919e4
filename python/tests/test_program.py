"""The same bytes as the program's."""

import numpy as np
import pytest

import firsthit as fh

PLANES = ["depth", "distance", "uv", "normal", "geometric_normal", "position", "albedo", "barycentric", "lit", "item",
          "instance", "material", "node", "tangent", "metallic_roughness", "emission", "normal_camera", "position_camera"]


def program_planes(program, folder, scene, words):
    names = [f for name in PLANES for f in ("--aov", f"{name}={name}.npy")]
    program("render", scene, "--size", "96x64", "--exr", "all.exr", *names, *words, folder=folder)
    return {name: np.load(folder / f"{name}.npy") for name in PLANES}


SCENES = [("builtin:torus", 0), ("builtin:robots", 0), ("builtin:robots", 2.5), ("builtin:robots", 9),
          ("builtin:wave?n=5000", 1), ("bunny", 0), ("colours", 0), ("flat", 0), ("quads", 0), ("lines", 0)]


@pytest.mark.parametrize("scene, time", SCENES)
def test_planes_are_the_programs(program, tmp_path, scene, time, request):
    scene = make_scene(scene, tmp_path, request)
    wanted = program_planes(program, tmp_path, scene, ["--time", str(time)])
    world = fh.load(scene).pose(time)
    camera = fh.scene_camera(world, size=(96, 64))
    frame = fh.render(world, camera, PLANES)
    for name in PLANES:
        assert frame[name].tobytes() == wanted[name].tobytes(), name
        assert frame[name].dtype == wanted[name].dtype


@pytest.mark.parametrize("words, given", [([], {}), (["--aa", "1", "--sky", "8"], {"aa": 1, "sky": 8}),
                                          (["--samples", "2", "--shadows", "map"], {"samples": 2, "shadows": "map"})])
@pytest.mark.parametrize("scene, time", SCENES)
def test_colours_are_the_programs(program, tmp_path, scene, time, words, given, request):
    scene = make_scene(scene, tmp_path, request)
    outputs = ["-o", "theirs.exr"] if words else ["-o", "theirs.png"]
    program("render", scene, "--size", "96x64", "--time", str(time), *outputs, *words, folder=tmp_path)
    world = fh.load(scene).pose(time)
    frame = fh.render(world, fh.scene_camera(world, size=(96, 64)), **given)
    for theirs in tmp_path.glob("theirs.*"):
        ours = theirs.with_stem("ours")
        frame.save(ours)
        assert ours.read_bytes() == theirs.read_bytes()


def test_alpha_is_the_programs(program, tmp_path):
    program("render", "builtin:torus", "--size", "96x64", "-o", "theirs.exr", "--background", "transparent", folder=tmp_path)
    scene = fh.load("builtin:torus", background=(0, 0, 0))
    assert scene.background == [0, 0, 0]
    world = scene.pose()
    frame = fh.render(world, fh.scene_camera(world, size=(96, 64)), ["color", "alpha"])
    frame.save(tmp_path / "ours.exr")
    assert (tmp_path / "ours.exr").read_bytes() == (tmp_path / "theirs.exr").read_bytes()
    assert 0 < np.count_nonzero(frame["alpha"] == 1) < np.count_nonzero(frame["alpha"]) < frame["alpha"].size


def test_motion_is_the_programs(program, tmp_path):
    program("render", "builtin:robots", "--size", "96x64", "--frames", "1:1.25:2", "-o", "%d.png", "--aov", "motion=m%d.npy",
            "--aov", "motion_visible=v%d.npy", folder=tmp_path)
    robots = fh.load("builtin:robots")
    worlds = [robots.pose(t) for t in (1, 1.25)]
    cameras = [fh.scene_camera(world, size=(96, 64)) for world in worlds]
    frame = fh.render(worlds[1], cameras[1], ["motion", "motion_visible"], previous=(worlds[0], cameras[0]))
    for name in ("motion", "motion_visible"):
        last = sorted(tmp_path.glob(f"{name[0] if name == 'motion' else 'v'}*.npy"))[-1]
        assert np.load(last).tobytes() == frame[name].tobytes() and frame[name].any()


def make_scene(name, folder, request):
    """A scene's name, or a file that is written."""
    if name == "bunny":
        return request.getfixturevalue("bunny")
    if name == "colours":
        path = folder / "colours.ply"
        path.write_text("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                        "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 3\n"
                        "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n"
                        "0 0 1 255 255 255\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
    elif name == "flat":
        path = folder / "flat.stl"
        path.write_text("solid a\n" + "".join(
            f"facet normal 0 0 1\nouter loop\nvertex {x} 0 0\nvertex {x + 1} 0 0\nvertex {x} 1 {x}\nendloop\nendfacet\n"
            for x in range(3)) + "endsolid\n")
    elif name == "quads":
        path = folder / "quads.obj"
        path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nvt 0 0\nvt 1 1\no a\nf 1/1 2/2 3/1 4/2\no b\n"
                        "f 1 2 6 5\n")
    elif name == "lines":
        path = folder / "mixed.off"
        path.write_text("OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n")
    else:
        return name
    return str(path)
