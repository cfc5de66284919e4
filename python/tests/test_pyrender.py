"""pyrender's scenes, by objects that have pyrender's fields."""

import types

import numpy as np
import pytest

import firsthit as fh
from firsthit.compat.pyrender import OffscreenRenderer, RenderFlags


class DirectionalLight(types.SimpleNamespace):
    pass


class Node:
    def __init__(self, **words):
        self.__dict__.update(words)


class Scene:
    """As pyrender.Scene: nodes with poses."""

    def __init__(self, **words):
        self.mesh_nodes, self.light_nodes, self.main_camera_node = [], [], None
        self.bg_color = np.array([1.0, 1.0, 1.0, 1.0])
        self.ambient_light = np.zeros(3)
        self.__dict__.update(words)

    def add(self, pose=np.eye(4), **content):
        node = Node(name=None, pose=np.asarray(pose, float), mesh=None, camera=None, light=None)
        node.__dict__.update(content)
        if node.mesh:
            self.mesh_nodes.append(node)
        if node.light:
            self.light_nodes.append(node)
        if node.camera:
            self.main_camera_node = node
        return node

    def get_pose(self, node):
        return node.pose


def moved(x=0, y=0, z=0):
    m = np.eye(4)
    m[:3, 3] = [x, y, z]
    return m


def square(color=(1, 1, 1, 1), **words):
    material = types.SimpleNamespace(**{**dict(baseColorFactor=color, metallicFactor=0.0, roughnessFactor=1.0, name="m",
                                               emissiveFactor=None, baseColorTexture=None, alphaMode="OPAQUE"), **words})
    primitive = types.SimpleNamespace(
        positions=np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32), normals=None,
        indices=np.array([[0, 1, 2], [0, 2, 3]]), material=material, mode=4, poses=None, texcoord_0=None, color_0=None)
    return types.SimpleNamespace(primitives=[primitive])


CAMERA = types.SimpleNamespace(yfov=np.pi / 3, znear=0.05, zfar=100.0, aspectRatio=None)
SUN = DirectionalLight(color=np.ones(3), intensity=np.pi, name="sun")


def one_square(**words):
    scene = Scene(**words)
    scene.add(mesh=square((0.5, 0.25, 1.0, 1.0)))
    scene.add(moved(z=3), camera=CAMERA)
    scene.add(light=SUN)
    return scene


def test_colour_and_depth():
    color, depth = OffscreenRenderer(64, 48).render(one_square())
    assert color.shape == (48, 64, 3) and color.dtype == np.uint8
    assert depth.shape == (48, 64) and depth.dtype == np.float32
    seen = depth > 0
    assert np.allclose(depth[seen], 3) and (color[~seen] == 255).all() and depth[0, 0] == 0
    # fov_y 60 degrees: half of the picture's height is 3 tan 30 degrees.
    half = 24 / (3 * np.tan(np.pi / 6))
    j, i = np.nonzero(seen)
    assert i.min() == round(32 - half) and i.max() == round(32 + half) - 1 and j.min() == round(24 - half)
    # A matt surface under light of pi that falls on it straight shows its colour, as sRGB, but for the coat.
    linear = np.array([0.5, 0.25, 1.0])
    srgb = 255 * (1.055 * linear ** (1 / 2.4) - 0.055)
    assert np.abs(color[24, 32] - srgb).max() < 8


def test_flags():
    scene = one_square(bg_color=np.array([0.0, 0.0, 0.0, 0.0]))
    renderer = OffscreenRenderer(64, 48)
    depth = renderer.render(scene, flags=RenderFlags.DEPTH_ONLY)
    assert depth.ndim == 2 and depth.dtype == np.float32
    rgba, _ = renderer.render(scene, flags=RenderFlags.RGBA)
    assert rgba.shape == (48, 64, 4) and rgba[24, 32, 3] == 255 and rgba[0, 0, 3] == 0
    flat, _ = renderer.render(scene, flags=RenderFlags.FLAT)
    assert np.abs(flat[24, 32] - 255 * (1.055 * np.array([0.5, 0.25, 1.0]) ** (1 / 2.4) - 0.055)).max() < 1
    other = scene.add(moved(x=1, z=0.5), mesh=square())
    segments, _ = renderer.render(scene, flags=RenderFlags.SEG, seg_node_map={scene.mesh_nodes[0]: (10, 0, 0), other: (0, 20, 0)})
    assert {tuple(c) for c in segments.reshape(-1, 3)} == {(0, 0, 0), (10, 0, 0), (0, 20, 0)}
    assert tuple(segments[24, 48]) == (0, 20, 0) and tuple(segments[24, 20]) == (10, 0, 0)
    # The second square's shadow falls on the first one where it is asked for.
    dark, _ = renderer.render(scene, flags=RenderFlags.SHADOWS_DIRECTIONAL)
    light, _ = renderer.render(scene)
    assert (dark.astype(int) <= light.astype(int) + 1).all() and dark.sum() <= light.sum()
    renderer.delete()


def test_intrinsics_cameras_are_those_of_opencv_with_corners():
    scene = one_square()
    scene.add(moved(z=3), camera=types.SimpleNamespace(fx=60.0, fy=50.0, cx=30.0, cy=20.0))
    depth = OffscreenRenderer(64, 48).render(scene, flags=RenderFlags.DEPTH_ONLY)
    j, i = np.nonzero(depth)
    assert (i.min(), i.max() + 1) == (30 - 20, 30 + 20)  # the square's corner is 1 beside and 3 away: 60 / 3 pixels
    assert j.min() == np.ceil(20 - 50 / 3 - 0.5) and j.max() == np.ceil(20 + 50 / 3 - 0.5) - 1


def test_orthographic_cameras_have_the_height_of_two_ymag():
    scene = one_square()
    scene.add(moved(z=3), camera=types.SimpleNamespace(xmag=7.0, ymag=1.5))
    depth = OffscreenRenderer(64, 48).render(scene, flags=RenderFlags.DEPTH_ONLY)
    j, i = np.nonzero(depth)
    assert (i.min(), i.max() + 1) == (32 - 16, 32 + 16)  # the square is 2 of 3 high, 32 of 48 pixels
    assert (j.min(), j.max() + 1) == (24 - 16, 24 + 16)
    np.testing.assert_allclose(depth[j, i], 3, rtol=1e-6)


def test_lights_ambient_textures_and_instances():
    picture = np.zeros((2, 2, 3), np.uint8)
    picture[0] = [255, 0, 0]
    picture[1] = [0, 0, 255]
    mesh = square(baseColorTexture=types.SimpleNamespace(source=picture))
    mesh.primitives[0].texcoord_0 = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32)
    mesh.primitives[0].poses = np.stack([moved(x=-1.1), moved(x=1.1)])
    scene = Scene(ambient_light=np.full(3, 0.5))
    scene.add(mesh=mesh)
    scene.add(moved(z=6), camera=CAMERA)
    scene.add(moved(z=5), light=types.SimpleNamespace(color=np.ones(3), intensity=100.0, name=None, range=None))
    color, depth = OffscreenRenderer(80, 60).render(scene)
    assert (depth[30, 10:36] > 0).any() and depth[30, 40] == 0 and (depth[30, 45:] > 0).any()
    rows, columns = np.nonzero(depth[:, :40])
    top, bottom, middle = rows.min(), rows.max() + 1, int(columns.mean())
    # A quarter below the top the picture's upper row is not mixed with another.
    above, below = color[top + (bottom - top) // 4, middle], color[bottom - (bottom - top) // 4 - 1, middle]
    assert above[0] > 150 and above[2] < 100 and below[2] > 150 and below[0] < 100
    plain = Scene(ambient_light=np.full(3, 0.5))
    plain.add(mesh=square((0.5, 1, 1, 1)))
    plain.add(moved(z=3), camera=CAMERA)
    color, _ = OffscreenRenderer(8, 8).render(plain)
    assert np.abs(color[4, 4] - 255 * (1.055 * np.array([0.25, 0.5, 0.5]) ** (1 / 2.4) - 0.055)).max() < 1.5
    spot = types.SimpleNamespace(color=np.ones(3), intensity=100.0, name=None, range=None, innerConeAngle=0.0,
                                 outerConeAngle=np.radians(10))
    plain.ambient_light = None
    plain.add(moved(z=3), light=spot)
    color, _ = OffscreenRenderer(64, 64).render(plain)
    assert color[32, 32].min() > 200 and color[32, 15].max() == 0


def test_what_cannot_be_rendered_says_so():
    with pytest.raises(ValueError, match="main_camera_node"):
        OffscreenRenderer(8, 8).render(Scene())
    scene = one_square()
    scene.mesh_nodes[0].mesh.primitives[0].mode = 1
    with pytest.raises(NotImplementedError, match="triangles"):
        OffscreenRenderer(8, 8).render(scene)
    scene = one_square()
    scene.add(camera=types.SimpleNamespace(fisheye=1.0))
    with pytest.raises(NotImplementedError, match="perspective"):
        OffscreenRenderer(8, 8).render(scene)
    assert issubclass(fh.SceneError, ValueError)
