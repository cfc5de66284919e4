"""Masks of what is seen, as the COCO data set has them."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _firsthit as _core
from ._types import Array

_NONE = 0xFFFFFFFF


def coco_rle(mask: Array) -> dict[str, list[int]]:
    """A mask, bool (H, W), as {"size": [height, width], "counts": runs down the columns, from those that are not in it}."""
    pixels = np.asarray(mask)
    if pixels.ndim != 2:
        raise ValueError(f"mask: got {pixels.dtype} {pixels.shape}, wanted bool (H, W)")
    column = np.concatenate([[False], pixels.astype(bool).ravel(order="F")])
    ends = np.nonzero(column[1:] != column[:-1])[0]
    counts = np.diff(np.concatenate([[0], ends, [pixels.size]]))
    return {"size": list(pixels.shape), "counts": [int(n) for n in counts]}


def coco_masks(frame: _core.Frame, channel: str = "instance") -> list[dict[str, Any]]:
    """What a frame sees of each object, in the layout of COCO's annotations: a list of dictionaries with the object's number
    under the channel's name, "segmentation", "area" in pixels, "bbox" [x, y, width, height] and "iscrowd" 0.

    channel  "instance", "node" or "material", which the frame has to have
    """
    ids = frame[channel]
    if ids.dtype != np.uint32:
        raise ValueError(f"channel: {channel!r} has no ids: accepted are instance, node, material and item")
    found = []
    for number in np.unique(ids[ids != _NONE]):
        mask = ids == number
        rows, columns = np.nonzero(mask.any(1))[0], np.nonzero(mask.any(0))[0]
        found.append({
            channel: int(number),
            "segmentation": coco_rle(mask),
            "area": int(np.count_nonzero(mask)),
            "bbox": [int(columns[0]), int(rows[0]), int(columns[-1] - columns[0] + 1), int(rows[-1] - rows[0] + 1)],
            "iscrowd": 0,
        })
    return found
