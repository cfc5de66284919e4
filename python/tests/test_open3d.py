"""Open3D's RaycastingScene: its documented conventions, and the real one beside ours where Debian's is installed.

Debian's Open3D 0.16 casts rays whose mask is 0, which Debian's Embree, built with masks of rays, has hit nothing. A small
library that is loaded before (open3d_ray_mask.cpp) sets the masks; FIRSTHIT_RAY_MASK names it.
"""

import os
import subprocess
import sys

import numpy as np
import pytest

import firsthit as fh
from conftest import random_mesh
from firsthit.compat.open3d import RaycastingScene

RAYS = dict(fov_deg=60, center=[0, 0, 0], eye=[0.2, 0.1, 3], up=[0, 1, 0], width_px=40, height_px=30)


def one_triangle():
    scene = RaycastingScene()
    scene.add_triangles(np.array([[-1, -1, 0], [1, -1, 0], [0, 1, 0]], np.float32), np.array([[0, 1, 2]], np.uint32))
    return scene


def test_the_dictionary():
    scene = one_triangle()
    assert scene.add_triangles([[5, 5, -1], [6, 5, -1], [5, 6, -1], [-9, -9, -5], [9, -9, -5], [0, 9, -5]],
                               [[0, 2, 1], [3, 4, 5]]) == 1
    rays = RaycastingScene.create_rays_pinhole(**RAYS)
    assert rays.shape == (30, 40, 6) and rays.dtype == np.float32
    hit = scene.cast_rays(rays)
    assert {name: (a.dtype.name, a.shape[2:]) for name, a in hit.items()} == {
        "t_hit": ("float32", ()), "geometry_ids": ("uint32", ()), "primitive_ids": ("uint32", ()),
        "primitive_uvs": ("float32", (2,)), "primitive_normals": ("float32", (3,))}
    near, far = hit["geometry_ids"] == 0, hit["geometry_ids"] == 1
    missed = hit["geometry_ids"] == RaycastingScene.INVALID_ID
    assert near.any() and far.any() and missed.any() and (near | far | missed).all()
    assert (hit["primitive_ids"][near] == 0).all() and (hit["primitive_ids"][far] == 1).all()
    assert (hit["primitive_ids"][missed] == RaycastingScene.INVALID_ID).all() and np.isinf(hit["t_hit"][missed]).all()
    assert (hit["primitive_uvs"][missed] == 0).all() and (hit["primitive_normals"][missed] == 0).all()
    assert np.allclose(hit["primitive_normals"][near], [0, 0, 1], atol=1e-6)
    # Along the ray by t lies the point that u and v name.
    at = rays[near][:, :3] + hit["t_hit"][near][:, None] * rays[near][:, 3:]
    u, v = hit["primitive_uvs"][near].T
    a, b, c = np.array([[-1, -1, 0], [1, -1, 0], [0, 1, 0]])
    assert np.allclose(at, np.outer(1 - u - v, a) + np.outer(u, b) + np.outer(v, c), atol=1e-5)


def test_normals_go_by_the_order_of_corners_seen_from_behind_too():
    scene = one_triangle()
    rays = RaycastingScene.create_rays_pinhole(60, [0, 0, 0], [0, 0, -3], [0, 1, 0], 16, 16)
    hit = scene.cast_rays(rays)
    assert np.allclose(hit["primitive_normals"][hit["geometry_ids"] == 0], [0, 0, 1], atol=1e-6)


def test_rays_of_any_length_and_shape():
    scene = one_triangle()
    rays = RaycastingScene.create_rays_pinhole(**RAYS)
    longer = rays * np.float32([1, 1, 1, 2, 2, 2])
    assert np.array_equal(scene.cast_rays(longer)["t_hit"] * 2, scene.cast_rays(rays)["t_hit"])
    assert scene.cast_rays(rays[0, 0])["t_hit"].shape == () and scene.cast_rays(rays[:0])["t_hit"].shape == (0, 30 + 10)
    assert np.array_equal(scene.cast_rays(rays.reshape(-1, 6))["t_hit"], scene.cast_rays(rays)["t_hit"].ravel())


def test_occlusions_counts_and_lists():
    scene = one_triangle()
    scene.add_triangles([[-9, -9, -5], [9, -9, -5], [0, 9, -5]], [[0, 1, 2]])
    rays = np.float32([[0, 0, 1, 0, 0, -1], [5, 0, 1, 0, 0, -1], [2, -1, 1, 0, 0, -2], [0, 0, -6, 0, 0, 1]])
    assert scene.count_intersections(rays).tolist() == [2, 0, 1, 2]
    assert scene.count_intersections(rays).dtype == np.int32
    assert scene.test_occlusions(rays).tolist() == [True, False, True, True]
    assert scene.test_occlusions(rays, tnear=1, tfar=1).tolist() == [True, False, False, True]
    assert scene.test_occlusions(rays, tnear=1.5, tfar=2).tolist() == [False] * 4
    hits = scene.list_intersections(rays)
    assert {name: (a.dtype.name, a.shape) for name, a in hits.items()} == {
        "ray_splits": ("uint32", (5,)), "ray_ids": ("uint32", (5,)), "t_hit": ("float32", (5,)),
        "geometry_ids": ("uint32", (5,)), "primitive_ids": ("uint32", (5,)), "primitive_uvs": ("float32", (5, 2))}
    assert hits["ray_splits"].tolist() == [0, 2, 2, 3, 5] and hits["ray_ids"].tolist() == [0, 0, 2, 3, 3]
    assert hits["t_hit"].tolist() == [1, 6, 3, 1, 6] and hits["geometry_ids"].tolist() == [0, 1, 1, 1, 0]
    assert hits["primitive_ids"].tolist() == [0] * 5
    empty = RaycastingScene()
    assert not empty.test_occlusions(rays).any() and np.isinf(empty.cast_rays(rays)["t_hit"]).all()


def test_what_is_refused():
    scene, rays = one_triangle(), RaycastingScene.create_rays_pinhole(**RAYS)
    for call in (scene.cast_rays, scene.test_occlusions, scene.count_intersections, scene.list_intersections):
        with pytest.raises(ValueError, match="wanted"):
            call(rays[..., :5])
    with pytest.raises(TypeError):
        RaycastingScene.create_rays_pinhole(60, [0, 0, 0], [0, 0, 1])
    with pytest.raises(TypeError, match="eyes"):
        RaycastingScene.create_rays_pinhole(60, [0, 0, 0], up=[0, 1, 0], eyes=[0, 0, 1], width_px=4, height_px=4)


BESIDE = r"""
import sys
import numpy as np
import open3d
from firsthit.compat.open3d import RaycastingScene
import firsthit as fh

Theirs = open3d.t.geometry.RaycastingScene
tensor = open3d.core.Tensor
meshes = np.load(sys.argv[1])
ours, theirs = RaycastingScene(), Theirs()
for k in range(int(meshes["count"])):
    v, t = meshes[f"v{k}"].astype(np.float32), meshes[f"t{k}"].astype(np.uint32)
    assert ours.add_triangles(v, t) == theirs.add_triangles(tensor(v), tensor(t)) == k
low, high = meshes["low"], meshes["high"]
middle, reach = (low + high) / 2, np.linalg.norm(high - low)
k = np.array([[200, 0, 80.0], [0, 200, 60.0], [0, 0, 1]])
pixels = ids = depths = normals = 0
for turn in range(4):
    angle = turn * np.pi / 2 + 0.3
    eye = middle + reach * np.array([np.cos(angle), 0.4, np.sin(angle)])
    camera = fh.look_at(eye, middle, size=(160, 120))
    kinds = [(60, middle, eye, [0, 1, 0], 160, 120), (k, fh.world_to_camera_opencv(camera), 160, 120)]
    for words in kinds:
        rays = Theirs.create_rays_pinhole(*[tensor(np.asarray(w, np.float64)) if np.ndim(w) else w for w in words])
        mine = RaycastingScene.create_rays_pinhole(*words)
        assert np.allclose(mine, rays.numpy(), atol=1e-6 * max(1, reach)), "the rays differ"
        a = ours.cast_rays(rays)
        b = {name: value.numpy() for name, value in theirs.cast_rays(rays).items()}
        assert set(a) == set(b)
        for name in a:
            assert a[name].dtype == b[name].dtype and a[name].shape == b[name].shape, name
        same = (a["geometry_ids"] == b["geometry_ids"]) & (a["primitive_ids"] == b["primitive_ids"])
        seen = same & (a["geometry_ids"] != 0xFFFFFFFF)
        pixels += same.size
        ids += (~same).sum()
        depths += (np.abs(a["t_hit"] - b["t_hit"])[seen] > 1e-4 * reach).sum()
        normals += (np.abs(a["primitive_normals"] - b["primitive_normals"])[seen].max(1) > 1e-3).sum()
        steep = np.abs(np.einsum("ij,ij->i", b["primitive_normals"][seen], rays.numpy()[seen][:, 3:])) > 0.2
        assert np.allclose(a["primitive_uvs"][seen][steep], b["primitive_uvs"][seen][steep], atol=2e-2)
rng = np.random.default_rng(1)
some = rng.uniform(low, high, (4000, 3))
some = np.concatenate([some, rng.uniform(low, high, (4000, 3)) - some], 1).astype(np.float32)
a, b = ours.cast_rays(some), {name: value.numpy() for name, value in theirs.cast_rays(tensor(some)).items()}
wrong = (a["primitive_ids"] != b["primitive_ids"]) | (a["geometry_ids"] != b["geometry_ids"])
assert wrong.sum() <= 8 and (a["geometry_ids"] != 0xFFFFFFFF).sum() > 400, "any rays"
counts = ours.count_intersections(some), theirs.count_intersections(tensor(some)).numpy()
assert counts[0].dtype == counts[1].dtype and (counts[0] != counts[1]).sum() <= 40, "counts"
occluded = [scene.test_occlusions(r, tnear=0.1, tfar=0.9) for scene, r in ((ours, some), (theirs, tensor(some)))]
assert occluded[0].dtype == occluded[1].numpy().dtype and (occluded[0] != occluded[1].numpy()).sum() <= 8, "occlusions"
print(pixels, int(seen.sum()), ids, depths, normals)
"""


def bunny_meshes(request):
    world = fh.load(request.getfixturevalue("bunny")).pose()
    return [(world.positions, world.scene.triangles)]


def robot_meshes(request):
    world = request.getfixturevalue("robots").pose(2)
    return [(world.positions[i["first_vertex"]:i["first_vertex"] + i["vertex_count"]],
             world.scene.triangles[i["first_triangle"]:i["first_triangle"] + i["triangle_count"]] - i["first_vertex"])
            for i in world.scene.instances]


@pytest.mark.parametrize("meshes", [bunny_meshes, robot_meshes, lambda request: [random_mesh(3), random_mesh(4)]],
                         ids=["bunny", "robots", "random"])
def test_open3d_beside_it(meshes, tmp_path, request):
    mask = os.environ.get("FIRSTHIT_RAY_MASK", "")
    if not os.path.isfile(mask):
        pytest.skip("FIRSTHIT_RAY_MASK names no library: Embree was not there")
    # In a process of its own: Open3D is large, and the library of masks has to be there first.
    if subprocess.run([sys.executable, "-c", "import open3d"], capture_output=True).returncode != 0:
        pytest.skip("there is no open3d: apt-get install python3-open3d")
    arrays, low, high = {}, [], []
    given = meshes(request)
    for k, (v, t) in enumerate(given):
        arrays[f"v{k}"], arrays[f"t{k}"] = v, t
        low.append(np.min(v, 0))
        high.append(np.max(v, 0))
    np.savez(tmp_path / "meshes.npz", count=len(given), low=np.min(low, 0), high=np.max(high, 0), **arrays)
    done = subprocess.run([sys.executable, "-c", BESIDE, tmp_path / "meshes.npz"], capture_output=True, text=True,
                          env={**os.environ, "LD_PRELOAD": mask})
    assert done.returncode == 0, done.stderr
    pixels, seen, ids, depths, normals = map(int, done.stdout.split())
    print(f"{pixels} rays: {ids} ids, {depths} distances and {normals} normals differ")
    assert seen > 100 and ids <= pixels * 1e-3 and depths <= 2 and normals <= 2
