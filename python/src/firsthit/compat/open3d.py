"""Open3D's RaycastingScene (0.16) for the rays of cameras.

    scene = RaycastingScene()
    mesh_id = scene.add_triangles(vertices, triangles)
    rays = RaycastingScene.create_rays_pinhole(fov_deg=60, center=[0, 0, 0], eye=[0, 0, 3], up=[0, 1, 0],
                                               width_px=640, height_px=480)
    scene.cast_rays(rays)["t_hit"]

Arrays are NumPy's in the place of Open3D's tensors, which are taken too. Rays have to be those of a pinhole camera, one for
each pixel, as create_rays_pinhole of Open3D or of this class makes them; other rays, occlusion tests and distances are not
there.
"""

import math

import numpy as np

from .. import _firsthit as _core
from ..cameras import from_opencv
from ..rendering import render
from ._arrays import to_numpy


class RaycastingScene:
    """Meshes, and what rays hit of them first. Open3D's names and conventions."""

    INVALID_ID = 0xFFFFFFFF

    def __init__(self, nthreads=0):
        self._meshes = []
        self._world = None
        self._first = None
        self._renderer = _core.Renderer(nthreads)

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
        """What each ray of a camera hits first: a dictionary of (H, W) and (H, W, k) arrays.

        t_hit              float32, in lengths of the ray's direction; inf where nothing is hit
        geometry_ids       uint32, of add_triangles; INVALID_ID
        primitive_ids      uint32, triangle of the geometry; INVALID_ID
        primitive_uvs      float32, weights of corners 1 and 2; 0
        primitive_normals  float32, unit, by the order of the corners; 0
        """
        camera, along = camera_of_rays(rays)
        world = self._posed()
        frame = render(world, camera, ["depth", "item", "instance", "barycentric", "geometric_normal"],
                       renderer=self._renderer)
        item, geometry = frame["item"], frame["instance"]
        seen = item != self.INVALID_ID
        primitive = np.where(seen, item - self._first[np.where(seen, geometry, 0)], self.INVALID_ID)
        normals = np.array(frame["geometric_normal"])
        corners = world.positions[world.scene.triangles[item[seen]]].astype(np.float64)
        ordered = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals[seen] *= np.where(np.einsum("ij,ij->i", ordered, normals[seen]) < 0, -1, 1)[:, None]
        return {
            "t_hit": frame["depth"] / np.float32(along),
            "geometry_ids": np.array(geometry),
            "primitive_ids": primitive.astype(np.uint32),
            "primitive_uvs": np.array(frame["barycentric"]),
            "primitive_normals": normals,
        }

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


def camera_of_rays(rays):
    """The Camera whose pixels have these rays, and how far each goes along the view axis in one length of its direction.

    rays    (H, W, 6), at least 2 x 2: one origin, and directions that change evenly from pixel to pixel
    throws  NotImplementedError: others
    """
    given = to_numpy(rays, np.float64)
    if given.ndim != 3 or given.shape[2] != 6:
        raise ValueError(f"rays: got {given.dtype} {given.shape}, wanted float32 (H, W, 6)")
    height, width = given.shape[:2]
    eye, direction = given[0, 0, :3], given[..., 3:]
    refused = NotImplementedError("cast_rays: only the rays of a pinhole camera can be cast, one for each pixel of "
                                  "(H, W, 6), at least 2 x 2, as create_rays_pinhole makes them")
    if height < 2 or width < 2 or not np.isfinite(given).all() or np.abs(given[..., :3] - eye).max() > 1e-6 * max(
            1.0, np.abs(eye).max()):
        raise refused
    # Directions are corner + x right + y down, by least squares over all pixels.
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    basis = np.stack([x, y, np.ones_like(x)], -1).reshape(-1, 3)
    fit = np.linalg.lstsq(basis, direction.reshape(-1, 3), rcond=None)[0]
    if np.abs(basis @ fit - direction.reshape(-1, 3)).max() > 1e-5 * np.abs(direction).max():
        raise refused
    right, down, corner = fit
    forward = np.cross(right, down)
    if not np.linalg.norm(forward) > 0:
        raise refused
    forward /= np.linalg.norm(forward)
    along = corner @ forward
    if not along > 0:
        raise refused  # nothing in front, or mirrored
    axis = right / np.linalg.norm(right)
    turn = np.stack([axis, np.cross(forward, axis), forward])
    k = np.linalg.inv(turn @ fit.T) * along  # pixels of directions
    matrix = np.eye(4)
    matrix[:3, :3] = turn
    matrix[:3, 3] = -turn @ eye
    k = np.triu(k / k[2, 2])
    return from_opencv(k, matrix, (width, height), pixel_center=0.5), along


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
