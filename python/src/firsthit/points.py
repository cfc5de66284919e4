"""Which points lights do not reach."""

from __future__ import annotations

import threading
from typing import Any, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _firsthit as _core
from ._types import Array

_own = threading.local()


def _occlusion() -> _core.Occlusion:
    if not hasattr(_own, "occlusion"):
        _own.occlusion = _core.Occlusion(0)
    return _own.occlusion


def occlusion(world: _core.World, points: Array, lights: Union[_core.Light, Sequence[_core.Light], None] = None, *,
              directions: Optional[Array] = None, receivers: Optional[Array] = None, packed: bool = False,
              occlusion: Optional[_core.Occlusion] = None) -> npt.NDArray[Any]:
    """Whether triangles stand between points and lights, exactly.

    points      (N, 3) world space
    lights      Lights, one or several; or
    directions  (L, 3) towards parallel lights, as towards the sun
    receivers   (N) id of the triangle that each point lies on, which does not occlude it; NO_ID: none
    packed      True: bits, bit k of byte j for point 8 j + k
    occlusion   an Occlusion, which keeps memory and threads; None: one of this thread
    returns     bool (L, N), or uint8 (L, ceil(N / 8)): true where a light does not arrive
    """
    if (lights is None) == (directions is None):
        raise ValueError("give lights or directions")
    if directions is not None:
        towards = np.asarray(directions, np.float64)
        if towards.ndim == 1:
            towards = towards[None]
        if towards.ndim != 2 or towards.shape[1] != 3:
            raise ValueError(f"directions: got {towards.dtype} {towards.shape}, wanted float64 (L, 3)")
        lights = [_core.Light("directional", direction=-d) for d in towards]
    elif isinstance(lights, _core.Light):
        lights = [lights]
    return (occlusion or _occlusion())._test(world, points, list(lights), receivers, packed)


def sky_light(world: _core.World, points: Array, normals: Array, sky: _core.Sky, *, receivers: Optional[Array] = None,
              occlusion: Optional[_core.Occlusion] = None) -> npt.NDArray[np.float32]:
    """The light that arrives at points from a Sky, as a picture of a white surface shows it: float32 (N, 3), linear."""
    return (occlusion or _occlusion())._sky(world, points, normals, sky, receivers)
