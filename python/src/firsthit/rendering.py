"""Pictures."""

from __future__ import annotations

import hashlib
import threading
from typing import Any, Callable, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _firsthit as _core

_own = threading.local()


def _renderer() -> _core.Renderer:
    if not hasattr(_own, "renderer"):
        _own.renderer = _core.Renderer(0)
    return _own.renderer


def _settings(world: _core.World, channels: Union[str, Sequence[str]], samples: Optional[int], aa: Optional[int],
              sky: Union[_core.Sky, int, None], shadows: str, engine: str, interleave: int) -> Any:
    if isinstance(channels, str):
        channels = [channels]
    channels = list(channels)
    colour = "color" in channels or "alpha" in channels
    if samples is not None and aa is not None and samples > 1 and aa > 1:
        raise ValueError("samples shoots its rays in every pixel, aa where there are edges: give one")
    if aa is None:
        aa = 4 if colour and samples is None and interleave == 1 and engine in ("cpu", "hybrid") else 1
    if not colour:
        sky = None
    elif sky is None:
        sky = _core.studio_sky() if world.scene.studio else None
    elif not isinstance(sky, _core.Sky):
        number = sky
        sky = _core.studio_sky() if world.scene.studio else _core.Sky(number)
        sky.directions = number
    return _core._Settings(channels, 1 if samples is None else samples, aa, engine, shadows, interleave, sky)


def render(world: _core.World, camera: _core.Camera, channels: Union[str, Sequence[str]] = ("color",), *,
           samples: Optional[int] = None, aa: Optional[int] = None, lights: Optional[Sequence[_core.Light]] = None,
           sky: Union[_core.Sky, int, None] = None, shadows: str = "auto", engine: str = "cpu",
           region: Optional[tuple[int, int, int, int]] = None, interleave: int = 1,
           previous: Optional[tuple[_core.World, _core.Camera]] = None, renderer: Optional[_core.Renderer] = None,
           out: Optional[_core.Frame] = None, progress: Optional[Callable[[float], object]] = None) -> _core.Frame:
    """A picture of a world: a Frame, whose channels are NumPy arrays over its own memory.

    channels    "color" (linear Rec.709), "alpha", "depth" (along the view axis), "distance" (from the eye), "item"
                (triangle ids), "instance", "material", "node", "normal", "geometric_normal", "position", "uv",
                "barycentric", "albedo", "lit", "tangent", "metallic_roughness", "emission", "motion", "motion_visible",
                "normal_camera", "position_camera"
    samples     N: N x N rays in every pixel
    aa          N: N x N rays where there may be an edge, for colour; None: 4, where samples is not given
    lights      Lights in the place of the scene's
    sky         a Sky, or its number of directions, 0 for none; None: the studio's, where the scene is in the studio
    shadows     "auto", "none", "map" or "exact"
    engine      "cpu", "hybrid", "gpu" or "auto"
    region      (x, y, width, height): only these pixels, as they are in the whole picture
    previous    (World, Camera) of the frame before, for "motion" and "motion_visible"
    renderer    a Renderer, which keeps memory and threads; None: one of this thread
    out         a Frame whose memory is written again: arrays that were taken from it change
    progress    a function of the share that is done; what it raises gives the frame up
    """
    settings = _settings(world, channels, samples, aa, sky, shadows, engine, interleave)
    frame = _core.Frame() if out is None else out
    extras = None
    if lights is not None or region is not None or previous is not None or progress is not None:
        extras = {"lights": None if lights is None else list(lights), "region": region, "progress": progress}
        if previous is not None:
            extras["previous_world"], extras["previous_camera"] = previous
    (renderer or _renderer())._render(world, camera, settings, extras, frame)
    return frame


def render_batch(world: _core.World, cameras: Sequence[_core.Camera], channels: Union[str, Sequence[str]] = ("color",), *,
                 samples: Optional[int] = None, aa: Optional[int] = None,
                 lights: Optional[Sequence[_core.Light]] = None, sky: Union[_core.Sky, int, None] = None,
                 shadows: str = "auto", engine: str = "cpu", threads: int = 0) -> list[_core.Frame]:
    """A Frame for each camera, on several threads; 0: one for each core."""
    settings = _settings(world, channels, samples, aa, sky, shadows, engine, 1)
    return _core._render_batch(world, list(cameras), settings, None if lights is None else list(lights), threads)


def visible(world: _core.World, cameras: Sequence[_core.Camera], *, threads: int = 0) -> npt.NDArray[np.uint64]:
    """How many pixels of all cameras see each triangle: uint64 (triangles)."""
    counts = np.zeros(world.scene.triangle_count, np.uint64)
    cameras = list(cameras)
    for first in range(0, len(cameras), 64):
        for frame in render_batch(world, cameras[first:first + 64], ["item"], threads=threads):
            seen = frame["item"]
            counts += np.bincount(seen[seen != 0xFFFFFFFF], minlength=len(counts)).astype(np.uint64)
    return counts


def hash_of(frame: _core.Frame) -> str:
    """SHA-256 of a frame's channels, as text: equal where all bytes are."""
    digest = hashlib.sha256()
    for name in frame.channels:
        array = frame[name]
        digest.update(f"{name} {array.dtype} {array.shape}\n".encode())
        digest.update(array)
    return digest.hexdigest()


_core.Frame.hash = hash_of
