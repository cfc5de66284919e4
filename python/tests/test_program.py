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


@pytest.mark.parametrize("scene, time", [("builtin:torus", 0), ("builtin:robots", 0), ("builtin:robots", 2.5),
                                         ("builtin:robots", 9), ("builtin:wave?n=5000", 1), ("bunny", 0), ("colours", 0),
                                         ("flat", 0), ("quads", 0), ("lines", 0)])
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
@pytest.mark.parametrize("scene", ["builtin:robots", "colours"])
def test_colours_are_the_programs(program, tmp_path, scene, words, given, request):
    scene = make_scene(scene, tmp_path, request)
    program("render", scene, "--size", "96x64", "--time", "1", "-o", "out.png", "--dither", "off", *words, folder=tmp_path)
    import struct
    import zlib

    world = fh.load(scene).pose(1)
    color = fh.render(world, fh.scene_camera(world, size=(96, 64)), **given)["color"].astype(np.float64)
    srgb = np.where(color <= 0.0031308, 12.92 * color, 1.055 * np.maximum(color, 1e-9) ** (1 / 2.4) - 0.055)
    data = (tmp_path / "out.png").read_bytes()
    body, k = b"", 8
    while k < len(data):
        length, kind = struct.unpack(">I4s", data[k:k + 8])
        body += data[k + 8:k + 8 + length] if kind == b"IDAT" else b""
        k += 12 + length
    rows = np.frombuffer(zlib.decompress(body), np.uint8).reshape(64, -1)
    codes = unfiltered(rows).reshape(64, 96, 3)
    assert np.abs(codes - np.clip(srgb, 0, 1) * 255).max() < 0.51


def unfiltered(rows):
    """The bytes of a PNG's rows of three channels."""
    out = np.zeros((rows.shape[0], rows.shape[1] - 1), np.int64)
    for y, row in enumerate(rows):
        above = out[y - 1] if y > 0 else np.zeros(out.shape[1], np.int64)
        for x, byte in enumerate(row[1:].astype(np.int64)):
            left = out[y, x - 3] if x >= 3 else 0
            corner = above[x - 3] if x >= 3 else 0
            guess = left + above[x] - corner
            paeth = min((left, above[x], corner), key=lambda v: abs(guess - v))
            out[y, x] = (byte + [0, left, above[x], (left + above[x]) // 2, paeth][row[0]]) % 256
    return out


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
