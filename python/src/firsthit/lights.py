"""Lights by their kinds."""

from __future__ import annotations

import math
from typing import Optional, Union

from . import _firsthit as _core
from ._types import Array, Color


def _color(color: Color, intensity: float) -> list[float]:
    return [float(c) * intensity for c in color]


def point(position: Array, *, color: Color = (1, 1, 1), intensity: float = 1.0, falloff: str = "none", range: float = 0.0,
          on_camera: bool = False, name: str = "") -> _core.Light:
    """A light that shines from a point to all sides. falloff: "none", or "square": by the distance's square, of which
    the colour is that at a distance of 1."""
    return _core.Light("point", position=position, color=_color(color, intensity), inverse_square=_square(falloff),
                       range=range, on_camera=on_camera, name=name)


def spot(position: Array, direction: Array, *, outer_deg: float = 45.0, inner_deg: float = 0.0, color: Color = (1, 1, 1),
         intensity: float = 1.0, falloff: str = "none", range: float = 0.0, on_camera: bool = False,
         name: str = "") -> _core.Light:
    """A light that shines into a cone. outer_deg, inner_deg: half angles where it ends, and up to which it is full."""
    return _core.Light("spot", position=position, direction=direction, color=_color(color, intensity),
                       inner=math.radians(inner_deg), outer=math.radians(outer_deg),
                       inverse_square=_square(falloff), range=range, on_camera=on_camera, name=name)


def directional(direction: Array, *, color: Color = (1, 1, 1), intensity: float = 1.0, on_camera: bool = False,
                name: str = "") -> _core.Light:
    """Parallel light. direction: the way that it goes."""
    return _core.Light("directional", direction=direction, color=_color(color, intensity), on_camera=on_camera,
                       name=name)


def sun(latitude: float, longitude: float, time: Union[str, float], *, up: str = "y", color: Color = (1, 1, 1),
        intensity: float = 1.0) -> Optional[_core.Light]:
    """The sun's light, by latitude and longitude in degrees (north and east are positive) and a time: seconds since 1970,
    or text in ISO 8601 with its zone, "2026-06-21T12:00Z".

    up     "y": x is east, z is south; "z": x is east, y is north
    returns a directional light; None where the sun is below the horizon
    """
    _, elevation, to_sun = _core.sun_position(latitude, longitude, time)
    if elevation <= 0:
        return None
    if up == "z":
        to_sun = (to_sun[0], -to_sun[2], to_sun[1])
    elif up != "y":
        raise ValueError(f"up: {up!r} is none: accepted are 'y' and 'z'")
    return directional([-c for c in to_sun], color=color, intensity=intensity, name="sun")


def _square(falloff: str) -> bool:
    if falloff not in ("none", "square"):
        raise ValueError(f"falloff: {falloff!r} is none: accepted are 'none' and 'square'")
    return falloff == "square"
