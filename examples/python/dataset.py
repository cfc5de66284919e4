"""A data set: pictures, depth and masks of an animated scene from all around, with the cameras' matrices.

    python3 dataset.py SCENE FOLDER [VIEWS]
"""

import json
import pathlib
import sys

import numpy as np

import firsthit as fh

scene = fh.load(sys.argv[1] if len(sys.argv) > 1 else "builtin:robots")
folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "dataset")
views = int(sys.argv[3]) if len(sys.argv) > 3 else 100
folder.mkdir(parents=True, exist_ok=True)

first = scene.pose(scene.begin)
cameras = fh.turntable(first, views, size=(320, 240))
pictures = []
for k, camera in enumerate(cameras):
    world = scene.pose(scene.begin + (scene.end - scene.begin) * k / views)
    frame = fh.render(world, camera, ["color", "depth", "instance"])
    name = f"{k:04d}.npz"
    np.savez_compressed(folder / name, color=frame["color"].astype(np.float16), depth=frame["depth"],
                        instance=frame["instance"])
    seen, pixels = np.unique(frame["instance"], return_counts=True)
    pictures.append({
        "file": name,
        "K": fh.intrinsics(camera).tolist(),  # pixel (0, 0) has its centre at (0, 0), as in OpenCV
        "world_to_camera": fh.world_to_camera_opencv(camera).tolist(),
        "pixels": {scene.instances[i]["name"] or str(i): int(n) for i, n in zip(seen, pixels) if i != fh.NO_ID},
    })
(folder / "cameras.json").write_text(json.dumps(pictures, indent=1))
print(f"{views} views of {scene.name} in {folder}")
