"""pyrender's OffscreenRenderer, on processors.

    renderer = OffscreenRenderer(640, 480)
    color, depth = renderer.render(scene)

A scene is pyrender's own or has the same fields: mesh_nodes, light_nodes, main_camera_node, get_pose(node), bg_color,
ambient_light; primitives have positions, indices, normals, texcoord_0, color_0, poses and a metallic-roughness material. Left
out: lines and points, skins, all maps but baseColorTexture, znear and
zfar. Both sides of every triangle are seen, as with SKIP_CULL_FACES. Colours are sRGB by its curve in the place of a power of
1 / 2.2, and shadows exact, so that pictures are not those of pyrender to the byte.
"""

import numpy as np

from .. import _firsthit as _core
from ..cameras import from_gltf, from_opencv, ortho
from ..lights import directional, point, spot
from ..rendering import render
from ._arrays import to_numpy


class RenderFlags:
    """pyrender's flags, of which OffscreenRenderer knows these; any of the shadows' turns all on."""

    NONE = 0
    DEPTH_ONLY = 1
    SHADOWS_DIRECTIONAL = 32
    SHADOWS_POINT = 64
    SHADOWS_SPOT = 128
    SHADOWS_ALL = 32 | 64 | 128
    SKIP_CULL_FACES = 1024
    RGBA = 2048
    FLAT = 4096
    SEG = 8192


class OffscreenRenderer:
    """Renders scenes of pyrender. point_size: nothing is looked at."""

    def __init__(self, viewport_width, viewport_height, point_size=1.0):
        self.viewport_width = viewport_width
        self.viewport_height = viewport_height
        self.point_size = point_size
        self._renderer = _core.Renderer()

    def render(self, scene, flags=RenderFlags.NONE, seg_node_map=None):
        """Color and depth: uint8 (H, W, 3), or 4 with RGBA, and float32 (H, W), along the view axis, 0 where nothing is.

        With DEPTH_ONLY depth alone. With FLAT colours without light. With SEG the colours are those of seg_node_map,
        {node: (r, g, b)}, 0 to 255; nodes that are not in it are black, and so is what sees nothing.
        """
        size = (self.viewport_width, self.viewport_height)
        if scene.main_camera_node is None:
            raise ValueError("the scene has no main_camera_node")
        camera = _camera(scene.main_camera_node.camera, to_numpy(scene.get_pose(scene.main_camera_node)), size)
        segments, depth_only = bool(flags & RenderFlags.SEG), bool(flags & RenderFlags.DEPTH_ONLY)
        made, nodes = _scene(scene, bool(flags & RenderFlags.FLAT), segments or depth_only)
        shadows = "exact" if flags & RenderFlags.SHADOWS_ALL else "none"
        channels = ["depth"]
        if segments:
            channels.append("instance")
        elif not depth_only:
            channels += ["color", "alpha"]
        frame = render(made.pose(), camera, channels, sky=0, shadows=shadows, renderer=self._renderer)
        depth = np.where(np.isinf(frame["depth"]), np.float32(0), frame["depth"])
        if depth_only:
            return depth
        if segments:
            table = np.zeros((len(nodes) + 1, 3), np.uint8)
            for k, node in enumerate(nodes):
                table[k] = (seg_node_map or {}).get(node, (0, 0, 0))
            return table[np.minimum(frame["instance"], len(nodes))], depth
        return _bytes(frame, _bg_color(scene), bool(flags & RenderFlags.RGBA)), depth

    def delete(self):
        """Nothing to free."""


def _bg_color(scene):
    given = getattr(scene, "bg_color", None)
    if given is None:
        return np.ones(4)
    color = to_numpy(given)
    color = color / 255.0 if color.dtype.kind in "iu" and color.max(initial=0) > 1 else color.astype(float)
    return np.concatenate([color, np.ones(4)])[:4] if len(color) == 3 else color


def _bytes(frame, background, with_alpha):
    """sRGB before a background, which is sRGB too."""
    cover = frame["alpha"][..., None]
    linear = np.clip(np.array(frame["color"]), 0, 1)
    behind = np.where(background[:3] <= 0.04045, background[:3] / 12.92, ((background[:3] + 0.055) / 1.055) ** 2.4)
    linear = linear + (1 - cover) * behind  # the scene's own background is black
    srgb = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)
    if with_alpha:
        srgb = np.concatenate([srgb, cover + (1 - cover) * background[3]], -1)
    return (np.clip(srgb, 0, 1) * 255 + 0.5).astype(np.uint8)


def _camera(camera, pose, size):
    if hasattr(camera, "yfov"):
        return from_gltf(pose, camera.yfov, size)
    if hasattr(camera, "ymag"):
        forward, up = -pose[:3, 2], pose[:3, 1]
        return ortho(pose[:3, 3], pose[:3, 3] + forward, up, size=size, height=2 * camera.ymag)
    if hasattr(camera, "fx"):
        k = [[camera.fx, 0, camera.cx], [0, camera.fy, camera.cy], [0, 0, 1]]
        return from_opencv(k, np.diag([1.0, -1, -1, 1]) @ np.linalg.inv(pose), size, pixel_center=0.5)
    raise NotImplementedError(f"{type(camera).__name__}: only perspective, orthographic and intrinsics cameras can be used")


def _scene(scene, unlit, plain):
    """A Scene, and the node of each of its instances. plain: without materials and lights."""
    builder = _core.SceneBuilder("pyrender")
    nodes = []
    ambient = np.zeros(3) if getattr(scene, "ambient_light", None) is None else to_numpy(scene.ambient_light, float)[:3]
    builder.set_ambient(10 * ambient)  # of which materials reflect a tenth of their colour
    for node in scene.mesh_nodes:
        pose = to_numpy(scene.get_pose(node), np.float64)
        for primitive in node.mesh.primitives if getattr(node.mesh, "is_visible", True) else ():
            if getattr(primitive, "mode", 4) not in (None, 4):
                raise NotImplementedError(f"primitive mode {primitive.mode}: only triangles (4) can be rendered")
            mesh = _mesh(builder, primitive)
            paint = builder.add_material(_core.Material() if plain else _material(primitive.material, unlit))
            poses = getattr(primitive, "poses", None)
            for local in [np.eye(4)] if poses is None else to_numpy(poses, np.float64):
                builder.add_instance(mesh, world_from_mesh=pose @ local, material=paint, name=node.name or "")
                nodes.append(node)
    if not plain:
        for node in scene.light_nodes:
            builder.add_light(_light(node.light, to_numpy(scene.get_pose(node), np.float64)))
    return builder.build(studio=False), nodes


def _mesh(builder, primitive):
    positions = to_numpy(primitive.positions)
    indices = getattr(primitive, "indices", None)
    triangles = np.arange(len(positions)).reshape(-1, 3) if indices is None else to_numpy(indices).reshape(-1, 3)

    def of(name):
        value = getattr(primitive, name, None)
        return None if value is None else to_numpy(value)

    return builder.add_mesh(positions, triangles, normals=of("normals"), uv=of("texcoord_0"),
                            colors=of("color_0"))


def _material(of, unlit):
    if of is None:
        return _core.Material(model="unlit" if unlit else "metallic_roughness", color=(1, 1, 1), roughness=1)
    base = np.ones(4) if getattr(of, "baseColorFactor", None) is None else to_numpy(of.baseColorFactor, float)
    emission = np.zeros(3) if getattr(of, "emissiveFactor", None) is None else to_numpy(of.emissiveFactor, float)
    texture = getattr(of, "baseColorTexture", None)
    texture = getattr(texture, "source", texture)
    mode = (getattr(of, "alphaMode", None) or "OPAQUE").lower()
    cutoff = getattr(of, "alphaCutoff", None)
    return _core.Material(model="unlit" if unlit else "metallic_roughness", name=getattr(of, "name", None) or "",
                          color=tuple(base[:3]),
                          metallic=float(of.metallicFactor), roughness=float(of.roughnessFactor),
                          emission=tuple(emission), alpha=mode, opacity=1.0 if mode == "opaque" else float(base[3]),
                          cutoff=0.5 if cutoff is None else float(cutoff),
                          texture=None if texture is None else to_numpy(texture))


def _light(light, pose):
    color = to_numpy(light.color, float)[:3]
    common = {"color": color, "intensity": float(light.intensity), "name": getattr(light, "name", None) or ""}
    eye, along = pose[:3, 3], -pose[:3, 2]
    reach = getattr(light, "range", None) or 0.0
    if hasattr(light, "outerConeAngle"):
        return spot(eye, along, outer_deg=np.degrees(light.outerConeAngle), inner_deg=np.degrees(light.innerConeAngle),
                    falloff="square", range=reach, **common)
    if "Directional" in type(light).__name__:
        return directional(along, **common)
    return point(eye, falloff="square", range=reach, **common)
