"""What any rays hit, exactly."""

from __future__ import annotations

import threading
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _firsthit as _core
from ._types import Array

_own = threading.local()


def _caster(given: Optional[_core.RayCaster]) -> _core.RayCaster:
    if given is not None:
        return given
    if not hasattr(_own, "caster"):
        _own.caster = _core.RayCaster(0)
    return _own.caster


def _floats(values: Array, name: str) -> npt.NDArray[np.float32]:
    array = np.asarray(values)
    if array.dtype.kind not in "fiub" or array.ndim < 1 or array.shape[-1] != 3:
        raise ValueError(f"{name}: got {array.dtype} {array.shape}, wanted numbers (..., 3)")
    with np.errstate(over="ignore"):
        return array.astype(np.float32, copy=False)


class _Rays:
    """Rays of any shape, as the compiled part takes them."""

    def __init__(self, world: Union[_core.World, _core.Scene], origins: Array, directions: Array,
                 skip: Optional[Array], tmin: Array, tmax: Array) -> None:
        self.world = world.pose(world.begin) if isinstance(world, _core.Scene) else world
        origins, directions = _floats(origins, "origins"), _floats(directions, "directions")
        first, last = np.asarray(tmin, np.float32), np.asarray(tmax, np.float32)
        ids = None if skip is None else np.asarray(skip)
        shapes = {"origins": origins.shape[:-1], "directions": directions.shape[:-1], "tmin": first.shape,
                  "tmax": last.shape, "skip": () if ids is None else ids.shape}
        try:
            self.shape = np.broadcast_shapes(*shapes.values())
        except ValueError:
            raise ValueError("rays of one shape are accepted, got " +
                             ", ".join(f"{name} {shape}" for name, shape in shapes.items())) from None
        limits = np.empty(self.shape + (2,), np.float32)
        limits[..., 0], limits[..., 1] = first, last
        self.arguments = (self._all(origins, (3,)), self._all(directions, (3,)), limits.reshape(-1, 2),
                          None if ids is None else self._all(ids, ()))

    def _all(self, array: npt.NDArray[Any], more: tuple[int, ...]) -> npt.NDArray[Any]:
        return np.ascontiguousarray(np.broadcast_to(array, self.shape + more)).reshape((-1,) + more)

    def shaped(self, array: npt.NDArray[Any]) -> npt.NDArray[Any]:
        return array.reshape(self.shape + array.shape[1:])


def cast(world: Union[_core.World, _core.Scene], origins: Array, directions: Array, *, skip: Optional[Array] = None,
         tmin: Array = 0.0, tmax: Array = np.inf, caster: Optional[_core.RayCaster] = None) -> dict[str, npt.NDArray[Any]]:
    """The nearest hit of each ray: the points origin + t direction with t > 0 and tmin <= t <= tmax.

    world       a World, or a Scene as it is at its begin
    origins     (..., 3) world space
    directions  (..., 3) of any length; shapes are broadcast, so that one origin may have many directions
    skip        id of a triangle that each ray does not hit, as the one it starts on; NO_ID: none
    caster      a RayCaster, which keeps its tree from call to call; None: one of this thread
    returns     "t" float32 (...), inf where nothing is hit; "triangle" and "instance" uint32 (...), NO_ID; "uv"
                float32 (..., 2), the weights of corners 1 and 2; "normal" float32 (..., 3), unit, by the order of the
                triangle's corners
    """
    rays = _Rays(world, origins, directions, skip, tmin, tmax)
    return {name: rays.shaped(a) for name, a in _caster(caster)._nearest(rays.world, *rays.arguments).items()}


def occluded(world: Union[_core.World, _core.Scene], origins: Array, directions: Array, *,
             skip: Optional[Array] = None, tmin: Array = 0.0, tmax: Array = np.inf,
             caster: Optional[_core.RayCaster] = None) -> npt.NDArray[np.bool_]:
    """Whether each ray hits anything: bool (...). Arguments as of cast. Whether b is hidden from a: origins a,
    directions b - a, tmax just below 1."""
    rays = _Rays(world, origins, directions, skip, tmin, tmax)
    return rays.shaped(_caster(caster)._occluded(rays.world, *rays.arguments))


def count_hits(world: Union[_core.World, _core.Scene], origins: Array, directions: Array, *,
               skip: Optional[Array] = None, tmin: Array = 0.0, tmax: Array = np.inf,
               caster: Optional[_core.RayCaster] = None) -> npt.NDArray[np.uint32]:
    """How many triangles each ray hits: uint32 (...). Arguments as of cast. A point is inside a closed surface where the
    number is odd."""
    rays = _Rays(world, origins, directions, skip, tmin, tmax)
    return rays.shaped(_caster(caster)._count(rays.world, *rays.arguments))


def all_hits(world: Union[_core.World, _core.Scene], origins: Array, directions: Array, *,
             skip: Optional[Array] = None, tmin: Array = 0.0, tmax: Array = np.inf,
             caster: Optional[_core.RayCaster] = None) -> dict[str, npt.NDArray[Any]]:
    """All hits of each ray, ray by ray in the order of t. Arguments as of cast.

    returns  what cast returns, each (H) or (H, k) for all H hits; "ray" int64 (H), the number of the ray, counted over
             the shape in C order; "first" int64 (N + 1): the hits of ray k are first[k] to first[k + 1] - 1
    """
    rays = _Rays(world, origins, directions, skip, tmin, tmax)
    hits = _caster(caster)._all_hits(rays.world, *rays.arguments)
    hits["first"] = hits["first"].astype(np.int64)
    hits["ray"] = np.repeat(np.arange(len(hits["first"]) - 1), np.diff(hits["first"]))
    return hits
