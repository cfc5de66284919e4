"""Masks in COCO's layout: what decoding them gives, and that they are the program's."""

import json

import numpy as np
import pytest

import firsthit as fh


def decoded(rle):
    """The mask of runs down the columns, the first of pixels that are not in it."""
    height, width = rle["size"]
    value, flat = False, []
    for count in rle["counts"]:
        flat += [value] * count
        value = not value
    return np.array(flat).reshape(width, height).T


@pytest.mark.parametrize("mask", [
    np.zeros((3, 4), bool), np.ones((3, 4), bool), np.eye(5, dtype=bool), ~np.eye(4, 6, dtype=bool),
    np.random.default_rng(1).random((20, 13)) < 0.5])
def test_masks_come_back(mask):
    rle = fh.coco_rle(mask)
    assert np.array_equal(decoded(rle), mask)
    assert all(n > 0 for n in rle["counts"][1:]) and json.dumps(rle)


def test_masks_of_a_frame(robots):
    world = robots.pose(3)
    frame = fh.render(world, fh.scene_camera(world, size=(96, 64)), ["instance", "node", "depth"])
    masks = fh.coco_masks(frame)
    seen = frame["instance"]
    assert [m["instance"] for m in masks] == [i for i in np.unique(seen) if i != fh.NO_ID]
    for mask in masks:
        pixels = decoded(mask["segmentation"])
        assert np.array_equal(pixels, seen == mask["instance"])
        x, y, w, h = mask["bbox"]
        inside = np.zeros_like(pixels)
        inside[y:y + h, x:x + w] = True
        assert not (pixels & ~inside).any() and pixels[y].any() and pixels[:, x].any()
        assert pixels[y + h - 1].any() and pixels[:, x + w - 1].any() and mask["area"] == pixels.sum()
    assert fh.coco_masks(frame, "node")[0]["node"] >= 0
    with pytest.raises(ValueError, match="ids"):
        fh.coco_masks(frame, "depth")
    with pytest.raises(KeyError):
        fh.coco_masks(frame, "material")


def test_masks_are_the_programs(program, tmp_path, robots):
    program("mask", "builtin:robots", "-o", "masks.json", "--time", "3", "--size", "96x64", "--counts", "list",
            folder=tmp_path)
    wanted = json.loads((tmp_path / "masks.json").read_text())["annotations"]
    world = robots.pose(3)
    got = fh.coco_masks(fh.render(world, fh.scene_camera(world, size=(96, 64)), ["instance"]))
    assert len(got) == len(wanted) > 2
    for ours, theirs in zip(got, wanted):
        assert ours == {name: theirs[name] for name in ours}
