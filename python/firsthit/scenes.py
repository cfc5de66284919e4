"""Scenes at a time."""

from . import _firsthit as _core


def posed(self, time=0.0, clip=None, *, camera=0, world=None, threads=0):
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
