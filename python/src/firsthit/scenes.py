"""Scenes from files, and scenes at a time."""

from __future__ import annotations

import os
import warnings
from typing import Optional, Union

from . import _firsthit as _core
from ._types import Color


def load(path: Union[str, os.PathLike[str]], *, clip: Union[str, int, None] = None, studio: Optional[bool] = None,
         scene: str = "", strict: bool = False, crease_angle: float = 30.0,
         background: Optional[Color] = None) -> _core.Scene:
    """Reads a scene. What its file says and the scene does not hold is told by warnings.warn, and in scene.warnings.

    clip          the animation of poses: name or number, "none"; None: the first
    studio        True: lights and background of the studio; None: where the file has no lights of its own
    scene         of a file with several: its name or number
    strict        True: a warning is an error
    crease_angle  degrees; normals that the file does not have are smooth across smaller angles
    background    linear colour in the place of the scene's; (0, 0, 0) for pictures with "alpha"
    """
    read = _core.load(path, clip=clip, studio=studio, scene=scene, strict=strict, crease_angle=crease_angle,
                      background=background)
    for text in read.warnings:
        warnings.warn(text, stacklevel=2)
    return read


def posed(self: _core.Scene, time: float = 0.0, clip: Union[str, int, None] = None, *, camera: int = 0,
          world: Optional[_core.World] = None, threads: int = 0) -> _core.World:
    """The scene at a time in seconds: a World.

    clip    name or number, "none" for the pose at rest; None: the scene's own choice
    camera  number of the scene's camera that World's camera is
    world   a World of this scene, whose arrays are written again; None: a new one
    """
    if world is None:
        world = _core._new_world(self)
    elif not _core._same_scene(world, self):
        raise _core.ArgumentError("world: it is of another scene")
    world._pose(time, self._clip_number(clip), camera, threads)
    return world


_core.Scene.pose = posed
