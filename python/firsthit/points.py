"""Which points lights do not reach."""

import threading

import numpy as np

from . import _firsthit as _core

_own = threading.local()


def _occlusion():
    if not hasattr(_own, "occlusion"):
        _own.occlusion = _core.Occlusion(0)
    return _own.occlusion


def occlusion(world, points, lights=None, *, directions=None, receivers=None, packed=False, occlusion=None):
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


def sky_light(world, points, normals, sky, *, receivers=None, occlusion=None):
    """The light that arrives at points from a Sky, as a picture of a white surface shows it: float32 (N, 3), linear."""
    return (occlusion or _occlusion())._sky(world, points, normals, sky, receivers)
