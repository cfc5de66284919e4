"""A data set for training: pictures, depth, masks and cameras of an animated scene from all around, with COCO's annotations.

    python3 dataset.py [SCENE [FOLDER [VIEWS]]]

Leaves in the folder 0000.png, 0000_depth.npy (float32, metres along the view axis), 0000_instance.npy (uint32) for each view,
coco.json, and cameras.json with K and the matrix to the camera as OpenCV has them.
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

cameras = fh.turntable(scene.pose(scene.begin), views, size=(320, 240))
# In K pixel (0, 0) has its centre at (0, 0), as in OpenCV.
K = fh.intrinsics(cameras[0])
views_as_matrices = [fh.world_to_camera_opencv(camera) for camera in cameras]

images, annotations, poses = [], [], []
for k, to_camera in enumerate(views_as_matrices):
    world = scene.pose(scene.begin + (scene.end - scene.begin) * k / views)
    camera = fh.from_opencv(K, to_camera, (320, 240))
    frame = fh.render(world, camera, ["color", "depth", "instance"])
    frame.save(folder / f"{k:04d}.png")
    np.save(folder / f"{k:04d}_depth.npy", frame["depth"])
    np.save(folder / f"{k:04d}_instance.npy", frame["instance"])
    images.append({"id": k + 1, "file_name": f"{k:04d}.png", "width": camera.width, "height": camera.height})
    for mask in fh.coco_masks(frame):
        annotations.append({"id": len(annotations) + 1, "image_id": k + 1, "category_id": mask["instance"] + 1, **mask})
    poses.append({"file": f"{k:04d}.png", "K": K.tolist(), "world_to_camera": to_camera.tolist(), "time": world.time})

categories = [{"id": k + 1, "name": i["name"] or f"instance {k}"} for k, i in enumerate(scene.instances)]
(folder / "coco.json").write_text(json.dumps({"images": images, "categories": categories, "annotations": annotations}))
(folder / "cameras.json").write_text(json.dumps(poses, indent=1))
assert annotations and sum(a["area"] for a in annotations) == sum(
    np.count_nonzero(np.load(folder / f"{k:04d}_instance.npy") != fh.NO_ID) for k in range(views))
print(f"{views} views of {scene.name} with {len(annotations)} masks in {folder}")
