"""Cameras by numbers, matrices and files.

A matrix is named after the way that it goes, and after whose camera axes it has: OpenCV's (x right, y down, z forward) or
OpenGL's (x right, y up, z towards the viewer), which are those of Blender, NeRF and glTF too.
"""

from __future__ import annotations

import math
import os
from typing import Optional, Union

import numpy as np

from . import _firsthit as _core
from ._types import Array, Floats, Size


def look_at(eye: Array, target: Array, up: Array = (0, 1, 0), *, size: Size, fov_y_deg: float = 45.0) -> _core.Camera:
    """A camera at `eye` that looks at `target`. size: (width, height) in pixels; fov_y_deg: full vertical angle."""
    direction = np.subtract(np.asarray(target, np.float64), np.asarray(eye, np.float64))
    return _core.Camera(eye=eye, direction=direction, up=up, size=size, fov_y=math.radians(fov_y_deg))


def ortho(eye: Array, target: Array, up: Array = (0, 1, 0), *, size: Size, height: float) -> _core.Camera:
    """An orthographic camera at `eye` that looks at `target`.

    height  of the picture, in world units; the width follows from size. What is behind the eye is not seen.
    """
    direction = np.subtract(np.asarray(target, np.float64), np.asarray(eye, np.float64))
    return _core.Camera(eye=eye, direction=direction, up=up, size=size, orthographic_height=height)


def _rigid(matrix: Array, name: str) -> Floats:
    m = np.asarray(matrix, np.float64)
    if m.shape == (3, 4):
        m = np.vstack([m, [0, 0, 0, 1]])
    if m.shape != (4, 4):
        raise ValueError(f"{name}: got {m.dtype} {m.shape}, wanted float64 (4, 4) or (3, 4)")
    turn = m[:3, :3]
    if not np.allclose(turn @ turn.T, np.eye(3), atol=1e-5) or np.linalg.det(turn) < 0:
        raise ValueError(f"{name}: its upper left (3, 3) is no rotation")
    return m


def from_opencv(K: Array, world_to_camera: Array, size: Size, *, pixel_center: float = 0.0) -> _core.Camera:
    """A calibrated camera, as OpenCV, COLMAP and most data sets have it.

    K                (3, 3): fx, skew, cx; 0, fy, cy; 0, 0, 1
    world_to_camera  (4, 4) or (3, 4), rows: [R | t], to axes x right, y down, z forward
    pixel_center     where pixel (0, 0) has its centre in K's pixels: 0 (OpenCV) or 0.5 (COLMAP, OpenGL)
    """
    k = np.asarray(K, np.float64)
    if k.shape != (3, 3):
        raise ValueError(f"K: got {k.dtype} {k.shape}, wanted float64 (3, 3)")
    if pixel_center not in (0, 0.5):
        raise ValueError(f"pixel_center: {pixel_center} is neither 0 nor 0.5")
    m = _rigid(world_to_camera, "world_to_camera")
    turn, shift = m[:3, :3], m[:3, 3]
    half = 0.5 - pixel_center
    return _core.Camera(eye=-turn.T @ shift, direction=turn[2], up=-turn[1], size=size, focal=(k[0, 0], k[1, 1]),
                        principal_point=(k[0, 2] + half, k[1, 2] + half), skew=k[0, 1])


def from_gltf(camera_to_world: Array, fov_y: float, size: Size) -> _core.Camera:
    """A camera of glTF's axes: looks along -z, y up. fov_y: full vertical angle, radians, as in the file."""
    m = _rigid(camera_to_world, "camera_to_world")
    return _core.Camera(eye=m[:3, 3], direction=-m[:3, 2], up=m[:3, 1], size=size, fov_y=fov_y)


def from_colmap(path: Union[str, os.PathLike[str]], *, size: Optional[Size] = None) -> dict[str, _core.Camera]:
    """The cameras of a folder with COLMAP's cameras.txt and images.txt, by the names of their pictures."""
    return {camera.name: camera for camera in _core.read_cameras(path, size=size)}


def framing(world: _core.World, view: str = "iso", *, size: Size, up: Optional[Array] = None,
            all_around: bool = False) -> _core.Camera:
    """The camera that shows all of a world.

    view        "iso", "front", "back", "left", "right", "top" or "bottom"
    up          what is up in the world, as (0, 0, 1); None: z for .stl, .ply and .3mf that do not rest on a flat bottom along
                y, else y
    all_around  True: all stays in the picture when the camera goes round it
    """
    z_up = world.scene.name.lower().endswith((".stl", ".ply", ".3mf"))
    usual = (0, 0, 1) if z_up else (0, 1, 0)
    return _core._frame(world, view, size, up, usual, all_around)


def scene_camera(world: _core.World, *, size: Size) -> _core.Camera:
    """The camera of the scene's file at the world's time; where it has none, the one that shows all of the world."""
    camera = _core._scene_camera(world, size)
    return framing(world, size=size) if camera is None else camera


def turntable(world: _core.World, count: int, *, size: Size, view: str = "iso",
              up: Optional[Array] = None) -> list[_core.Camera]:
    """`count` cameras of one turn around the world."""
    camera = framing(world, view, size=size, up=up, all_around=True)
    low, high = world.bounds
    axis = up if up is not None else camera.up
    return [camera.turned((low + high) / 2, axis, 2 * math.pi * k / count) for k in range(count)]


def intrinsics(camera: _core.Camera, *, pixel_center: float = 0.0) -> Floats:
    """K of a camera, float64 (3, 3). An orthographic one has none: ValueError."""
    if camera.focal is None:
        raise ValueError("camera: an orthographic camera has no K")
    fx, fy = camera.focal
    cx, cy = camera.principal_point
    half = 0.5 - pixel_center
    return np.array([[fx, camera.skew, cx - half], [0, fy, cy - half], [0, 0, 1]])


def world_to_camera_opencv(camera: _core.Camera) -> Floats:
    """(4, 4), rows: from the world to axes x right, y down, z forward."""
    forward = camera.direction / np.linalg.norm(camera.direction)
    right = np.cross(forward, camera.up)
    right /= np.linalg.norm(right)
    turn = np.array([right, np.cross(forward, right), forward])
    m = np.eye(4)
    m[:3, :3] = turn
    m[:3, 3] = -turn @ camera.eye
    return m


def camera_to_world_opencv(camera: _core.Camera) -> Floats:
    """(4, 4), rows: from axes x right, y down, z forward to the world."""
    return np.linalg.inv(world_to_camera_opencv(camera))


def world_to_camera_opengl(camera: _core.Camera) -> Floats:
    """(4, 4), rows: from the world to axes x right, y up, z towards the viewer."""
    return np.diag([1.0, -1, -1, 1]) @ world_to_camera_opencv(camera)


def camera_to_world_opengl(camera: _core.Camera) -> Floats:
    """(4, 4), rows: from axes x right, y up, z towards the viewer to the world."""
    return np.linalg.inv(world_to_camera_opengl(camera))
