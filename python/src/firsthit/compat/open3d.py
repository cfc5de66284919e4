"""Open3D's RaycastingScene for any rays (0.16; list_intersections is of 0.17).

    scene = RaycastingScene()
    mesh_id = scene.add_triangles(vertices, triangles)
    rays = RaycastingScene.create_rays_pinhole(fov_deg=60, center=[0, 0, 0], eye=[0, 0, 3], up=[0, 1, 0],
                                               width_px=640, height_px=480)
    scene.cast_rays(rays)["t_hit"]

Arrays are NumPy's in the place of Open3D's tensors, which are taken too. Answers are exact (docs/rays.md): a ray through an edge
that triangles share counts one of them, and one that starts exactly in a triangle's plane does not hit it. Closest points and
distances are not there.
"""

import math

import numpy as np

from .. import _firsthit as _core
from ..rays import all_hits, cast, count_hits, occluded
from ._arrays import to_numpy


class RaycastingScene:
    """Meshes, and what rays hit of them first. Open3D's names and conventions."""

    INVALID_ID = 0xFFFFFFFF

    def __init__(self, nthreads=0):
        self._meshes = []
        self._world = None
        self._first = None
        self._caster = _core.RayCaster(nthreads)

    def add_triangles(self, vertex_positions, triangle_indices=None):
        """Adds a mesh: (V, 3) and (T, 3), or an Open3D TriangleMesh of either kind. Returns its id, from 0."""
        if triangle_indices is None:
            mesh = vertex_positions
            if hasattr(mesh, "triangles"):
                vertex_positions, triangle_indices = mesh.vertices, mesh.triangles
            else:
                vertex_positions, triangle_indices = mesh.vertex["positions"], mesh.triangle["indices"]
        self._meshes.append((to_numpy(vertex_positions), to_numpy(triangle_indices)))
        self._world = None
        return len(self._meshes) - 1

    @staticmethod
    def create_rays_pinhole(*args, **names):
        """Rays of a camera, float32 (height_px, width_px, 6): origins, and directions that advance by 1 along the view axis.

        create_rays_pinhole(intrinsic_matrix, extrinsic_matrix, width_px, height_px): K, of which pixel (0, 0) has its
        centre at (0.5, 0.5), and the matrix from the world to axes x right, y down, z forward; or
        create_rays_pinhole(fov_deg, center, eye, up, width_px, height_px): fov_deg is horizontal; as in Open3D the
        picture's rows go towards `up`.
        """
        count = len(args) + len(names)
        if count == 4:
            return _rays(*_bound(args, names, ("intrinsic_matrix", "extrinsic_matrix", "width_px", "height_px")))
        if count == 6:
            return _rays_by_points(*_bound(args, names, ("fov_deg", "center", "eye", "up", "width_px", "height_px")))
        raise TypeError("create_rays_pinhole takes (intrinsic_matrix, extrinsic_matrix, width_px, height_px) or "
                        "(fov_deg, center, eye, up, width_px, height_px)")

    def cast_rays(self, rays, nthreads=0):
        """What each ray (..., 6) hits first: a dictionary of (...) and (..., k) arrays.

        t_hit              float32, in lengths of the ray's direction; inf where nothing is hit
        geometry_ids       uint32, of add_triangles; INVALID_ID
        primitive_ids      uint32, triangle of the geometry; INVALID_ID
        primitive_uvs      float32, weights of corners 1 and 2; 0
        primitive_normals  float32, unit, by the order of the corners; 0

        nthreads is taken, and means nothing: the class has its number.
        """
        hits = cast(self._posed(), *_origins_and_directions(rays), caster=self._caster)
        return {"t_hit": hits["t"], "geometry_ids": hits["instance"], "primitive_ids": self._primitives(hits),
                "primitive_uvs": hits["uv"], "primitive_normals": hits["normal"]}

    def test_occlusions(self, rays, tnear=0.0, tfar=math.inf, nthreads=0):
        """Whether each ray hits anything with tnear <= t <= tfar: bool (...)."""
        return occluded(self._posed(), *_origins_and_directions(rays), tmin=tnear, tmax=tfar, caster=self._caster)

    def count_intersections(self, rays, nthreads=0):
        """How many triangles each ray hits: int32 (...)."""
        return count_hits(self._posed(), *_origins_and_directions(rays), caster=self._caster).astype(np.int32)

    def list_intersections(self, rays, nthreads=0):
        """All that each ray hits, ray by ray in the order of t: a dictionary of (H) and (H, 2) arrays.

        ray_splits  uint32 (N + 1), of ray k are ray_splits[k] to ray_splits[k + 1] - 1; ray_ids uint32; t_hit,
        geometry_ids, primitive_ids and primitive_uvs as of cast_rays
        """
        hits = all_hits(self._posed(), *_origins_and_directions(rays), caster=self._caster)
        return {"ray_splits": hits["first"].astype(np.uint32), "ray_ids": hits["ray"].astype(np.uint32),
                "t_hit": hits["t"], "geometry_ids": hits["instance"], "primitive_ids": self._primitives(hits),
                "primitive_uvs": hits["uv"]}

    def _primitives(self, hits):
        seen = hits["triangle"] != self.INVALID_ID
        first = self._first[np.where(seen, hits["instance"], 0)] if len(self._first) else 0
        return np.where(seen, hits["triangle"] - first, self.INVALID_ID).astype(np.uint32)

    def _posed(self):
        if self._world is None:
            builder = _core.SceneBuilder()
            material = builder.add_material(_core.Material())
            counts = []
            for vertices, triangles in self._meshes:
                # With normals vertices are not doubled; nobody looks at these.
                mesh = builder.add_mesh(vertices, triangles, normals=np.tile([0.0, 0, 1], (len(vertices), 1)))
                builder.add_instance(mesh, material=material)
                counts.append(len(triangles))
            self._first = np.concatenate([[0], np.cumsum(counts)]).astype(np.uint32)
            self._world = builder.build().pose()
        return self._world


def _origins_and_directions(rays):
    given = to_numpy(rays)
    if given.ndim < 1 or given.shape[-1] != 6 or given.dtype.kind not in "fiu":
        raise ValueError(f"rays: got {given.dtype} {given.shape}, wanted float32 (..., 6)")
    return given[..., :3], given[..., 3:]


def _bound(args, names, wanted):
    unknown = [name for name in names if name not in wanted[len(args):]]
    if unknown:
        raise TypeError(f"create_rays_pinhole: {unknown[0]!r} is given twice or is none of {', '.join(wanted)}")
    return list(args) + [names[name] for name in wanted[len(args):]]


def _rays(intrinsic_matrix, extrinsic_matrix, width_px, height_px):
    k, t = to_numpy(intrinsic_matrix, np.float64), to_numpy(extrinsic_matrix, np.float64)
    if k.shape != (3, 3) or t.shape != (4, 4):
        raise ValueError(f"got {k.shape} and {t.shape}, wanted intrinsic_matrix (3, 3) and extrinsic_matrix (4, 4)")
    turn = t[:3, :3]
    x, y = np.meshgrid(np.arange(width_px) + 0.5, np.arange(height_px) + 0.5)
    pixels = np.stack([x, y, np.ones_like(x)], -1)
    rays = np.empty((height_px, width_px, 6), np.float32)
    rays[..., :3] = -turn.T @ t[:3, 3]
    rays[..., 3:] = pixels @ np.linalg.inv(k).T @ turn
    return rays


def _rays_by_points(fov_deg, center, eye, up, width_px, height_px):
    center, eye, up = (to_numpy(v, np.float64) for v in (center, eye, up))
    forward = center - eye
    forward /= np.linalg.norm(forward)
    right = np.cross(up, forward)
    right /= np.linalg.norm(right)
    turn = np.stack([right, np.cross(forward, right), forward])
    focal = 0.5 * width_px / math.tan(math.radians(fov_deg) / 2)
    t = np.eye(4)
    t[:3, :3] = turn
    t[:3, 3] = -turn @ eye
    return _rays([[focal, 0, 0.5 * width_px], [0, focal, 0.5 * height_px], [0, 0, 1]], t, width_px, height_px)
