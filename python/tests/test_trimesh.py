"""trimesh's meshes and scenes, by objects that have trimesh's fields."""

import types

import numpy as np
import pytest

import firsthit as fh
from conftest import random_mesh
from firsthit.compat.trimesh import RayMeshIntersector, scene_of

V = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
F = np.array([[0, 1, 2], [0, 2, 3]])


def mesh(visual=None):
    return types.SimpleNamespace(vertices=V, faces=F, visual=visual, vertex_normals=np.tile([0.0, 0, 1], (4, 1)))


def colour_at(scene, front, row=24, column=32):
    return fh.render(scene.pose(), front, ["albedo"])["albedo"][row, column]


def test_a_mesh_keeps_its_triangles(front):
    scene = scene_of(mesh())
    assert scene.triangle_count == 2
    item = fh.render(scene.pose(), front, ["item"])["item"]
    assert item[30, 40] == 0 and item[15, 22] == 1
    assert scene_of(mesh(), smooth=True).vertex_count == 4
    assert scene_of([mesh(), mesh()]).triangle_count == 4 and len(scene_of([mesh(), mesh()]).instances) == 2


def test_colours_of_vertices_faces_and_textures(front):
    vertex = types.SimpleNamespace(kind="vertex", vertex_colors=np.tile(np.uint8([255, 0, 0, 255]), (4, 1)))
    assert np.allclose(colour_at(scene_of(mesh(vertex)), front), [1, 0, 0], atol=1e-6)
    face = types.SimpleNamespace(kind="face", face_colors=np.uint8([[0, 255, 0, 255], [0, 0, 255, 255]]))
    scene = scene_of(mesh(face))
    assert np.allclose(colour_at(scene, front, 30, 40), [0, 1, 0], atol=1e-6)
    assert np.allclose(colour_at(scene, front, 15, 22), [0, 0, 1], atol=1e-6)
    image = np.zeros((2, 2, 3), np.uint8)
    image[0, :, 0] = image[1, :, 2] = 255
    texture = types.SimpleNamespace(kind="texture", uv=np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float),
                                    material=types.SimpleNamespace(image=image, diffuse=None, name=None))
    scene = scene_of(mesh(texture))
    above, below = colour_at(scene, front, 15), colour_at(scene, front, 33)
    assert above[0] > 0.9 and above[2] < 0.1 and below[2] > 0.9 and below[0] < 0.1
    pbr = types.SimpleNamespace(kind="texture", uv=None, material=types.SimpleNamespace(
        baseColorTexture=None, baseColorFactor=np.uint8([51, 102, 255, 255]), name="blue"))
    assert np.allclose(colour_at(scene_of(mesh(pbr)), front), [0.2, 0.4, 1], atol=1e-6)
    assert np.allclose(colour_at(scene_of(mesh(pbr), material=fh.Material(color=(1, 0, 0))), front), [1, 0, 0], atol=1e-6)


class Graph:
    nodes_geometry = ["left", "right"]

    def __getitem__(self, node):
        matrix = np.eye(4)
        matrix[0, 3] = -0.7 if node == "left" else 0.7
        matrix[0, 0] = matrix[1, 1] = 0.4
        return matrix, "square"


def test_a_scene_has_its_graphs_instances(front):
    scene = scene_of(types.SimpleNamespace(geometry={"square": mesh()}, graph=Graph()))
    assert [i["name"] for i in scene.instances] == ["left", "right"]
    seen = fh.render(scene.pose(), front, ["instance"])["instance"]
    assert set(np.unique(seen[:, :32])) == {0, fh.NO_ID} and set(np.unique(seen[:, 32:])) == {1, fh.NO_ID}


def test_rays():
    above = types.SimpleNamespace(vertices=np.concatenate([V, V + [0, 0, 1]]), faces=np.concatenate([F, F + 4]))
    ray = RayMeshIntersector(above)
    origins = np.array([[0.5, -0.2, 3], [-0.5, 0.2, 3], [4, 0, 3], [0.5, -0.2, 0.5]])
    directions = np.tile([0.0, 0, -2], (4, 1))
    assert ray.intersects_first(origins, directions).tolist() == [2, 3, -1, 0]
    assert ray.intersects_any(origins, directions).tolist() == [True, True, False, True]
    places, index_ray, index_tri = ray.intersects_location(origins, directions)
    assert index_ray.tolist() == [0, 0, 1, 1, 3] and index_tri.tolist() == [2, 0, 3, 1, 0]
    assert np.allclose(places[:, 2], [1, 0, 1, 0, 0]) and np.allclose(places[:, :2], origins[index_ray, :2])
    assert places.dtype == np.float64 and index_ray.dtype == index_tri.dtype == np.int64
    places, index_ray, index_tri = ray.intersects_location(origins, directions, multiple_hits=False)
    assert index_ray.tolist() == [0, 1, 3] and index_tri.tolist() == [2, 3, 0]
    index_tri, index_ray = ray.intersects_id(origins, directions, max_hits=1)
    assert index_ray.tolist() == [0, 1, 3] and index_tri.tolist() == [2, 3, 0]
    assert ray.intersects_id(origins, directions, return_locations=True)[2].shape == (5, 3)
    assert ray.intersects_id(origins[:0], directions[:0], return_locations=True)[2].shape == (0, 3)
    above.vertices = above.vertices + [0, 0, 0.25]
    assert ray.intersects_location(origins[:1], directions[:1])[0][0, 2] == 1.25


def test_points_inside():
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4],
             [1, 5, 7], [1, 7, 3]]
    box = types.SimpleNamespace(vertices=corners, faces=np.array(faces))
    points = np.random.default_rng(1).uniform(-2, 2, (500, 3))
    assert np.array_equal(RayMeshIntersector(box).contains_points(points), np.abs(points).max(1) < 1)


def test_rays_beside_the_real_trimesh():
    trimesh = pytest.importorskip("trimesh")
    vertices, triangles = random_mesh(3, 200)
    real = trimesh.Trimesh(vertices, triangles, process=False)
    rng = np.random.default_rng(1)
    origins, directions = rng.uniform(-1, 1, (2, 300, 3))
    ours, theirs = RayMeshIntersector(real), trimesh.ray.ray_triangle.RayMeshIntersector(real)
    assert (ours.intersects_first(origins, directions) != theirs.intersects_first(origins, directions)).sum() <= 2
    assert (ours.intersects_any(origins, directions) != theirs.intersects_any(origins, directions)).sum() <= 1


def test_the_real_trimesh(front):
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box()
    assert scene_of(box).triangle_count == len(box.faces)
    assert scene_of(trimesh.Scene([box])).triangle_count == len(box.faces)
