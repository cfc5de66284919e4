"""Exact ids, depth, shadows and pictures of moving triangle scenes, as NumPy arrays.

    import firsthit as fh

    scene = fh.load("walk.glb")
    world = scene.pose(0.5)
    camera = fh.look_at(eye=(0, 1, 4), target=(0, 1, 0), size=(640, 480))
    frame = fh.render(world, camera, channels=["color", "depth", "instance"])
    frame["depth"]                                # float32 (480, 640), metres along the view axis

Arrays have the picture's top row first. Ids that stand for nothing are 0xFFFFFFFF, depths +inf. Angles are degrees
where a name ends in _deg or a text says so, else radians.
"""

try:
    from . import _firsthit
except ImportError as error:
    if error.name not in (None, "firsthit._firsthit", "firsthit") or "_firsthit" not in str(error):
        raise
    raise ImportError("firsthit: this folder has no compiled module for this Python: build it and put build/release/python into "
                      "PYTHONPATH, or use pip install (docs/python.md)") from error
from ._firsthit import (
    ArgumentError,
    Camera,
    Cancelled,
    DeviceError,
    Error,
    FileError,
    Frame,
    Light,
    Material,
    Occlusion,
    RayCaster,
    Renderer,
    Scene,
    SceneBuilder,
    SceneError,
    Sky,
    World,
    __version__,
    compare,
    instruction_set,
    read_cameras,
    studio_sky,
    sun_position,
)
from .cameras import (
    camera_to_world_opencv,
    camera_to_world_opengl,
    framing,
    from_colmap,
    from_gltf,
    from_opencv,
    intrinsics,
    look_at,
    ortho,
    scene_camera,
    turntable,
    world_to_camera_opencv,
    world_to_camera_opengl,
)
from .lights import directional, point, spot, sun
from .masks import coco_masks, coco_rle
from .points import occlusion, sky_light
from .rays import all_hits, cast, count_hits, occluded
from .rendering import hash_of, render, render_batch, visible
from .scenes import load, posed

NO_ID = 0xFFFFFFFF
"""The id of pixels that see nothing."""

__all__ = [
    "ArgumentError", "Camera", "Cancelled", "DeviceError", "Error", "FileError", "Frame", "Light", "Material",
    "NO_ID", "Occlusion", "RayCaster", "Renderer", "Scene", "SceneBuilder", "SceneError", "Sky", "World", "all_hits",
    "camera_to_world_opencv", "camera_to_world_opengl", "cast", "coco_masks", "coco_rle", "compare", "count_hits",
    "directional", "framing", "from_colmap", "from_gltf", "from_opencv", "hash_of", "instruction_set", "intrinsics",
    "load", "look_at", "occluded", "occlusion", "ortho", "point", "posed", "read_cameras", "render", "render_batch", "scene_camera",
    "sky_light",
    "spot", "studio_sky", "sun", "sun_position", "turntable", "visible", "world_to_camera_opencv",
    "world_to_camera_opengl",
]
