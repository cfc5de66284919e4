"""trimesh's meshes and scenes as scenes, and its ray queries.

    mesh.ray = RayMeshIntersector(mesh)
    locations, index_ray, index_tri = mesh.ray.intersects_location(origins, directions)

Meshes and scenes are taken by what they have: vertices, faces, visual, geometry, graph. Answers to rays are exact (docs/rays.md);
hits come ray by ray in the order of their distance, and a ray through an edge hits one of the faces that share it.
"""

import numpy as np

from .. import _firsthit as _core
from ..rays import all_hits, cast, occluded
from ._arrays import to_numpy


def scene_of(source, *, smooth=False, material=None, name="trimesh", studio=None):
    """A Scene of a trimesh.Trimesh, a list of them, or a trimesh.Scene with its graph; triangles keep their order.

    smooth    True: shaded by vertex_normals; False: flat, as the faces are
    material  a Material for all; None: by each mesh's visual: colours of vertices, else of its material, else grey
    """
    builder = _core.SceneBuilder(name)
    if hasattr(source, "geometry") and hasattr(source, "graph"):
        known = {}
        for node in source.graph.nodes_geometry:
            matrix, geometry = source.graph[node]
            if geometry not in known:
                known[geometry] = _add(builder, source.geometry[geometry], str(geometry), smooth, material)
            mesh, paint = known[geometry]
            builder.add_instance(mesh, world_from_mesh=to_numpy(matrix, np.float64), material=paint, name=str(node))
    else:
        for k, mesh in enumerate([source] if hasattr(source, "faces") else source):
            number, paint = _add(builder, mesh, f"mesh {k}", smooth, material)
            builder.add_instance(number, material=paint, name=f"mesh {k}")
    return builder.build(studio=studio)


class RayMeshIntersector:
    """What rays hit of a mesh: trimesh.ray's queries of that name, which a mesh has as mesh.ray."""

    def __init__(self, geometry=None, **kwargs):
        self.mesh = kwargs["mesh"] if geometry is None and "mesh" in kwargs else geometry
        self._caster = _core.RayCaster()
        self._made_of = self._world = None

    def intersects_id(self, ray_origins, ray_directions, multiple_hits=True, max_hits=20, return_locations=False, **_):
        """Faces and rays of all hits, or of the nearest of each ray: int64 (H), (H), and where asked their places, float64
        (H, 3). max_hits: the nearest so many of each ray."""
        tri, ray, places = self._hits(ray_origins, ray_directions, max_hits if multiple_hits else 1)
        return (tri, ray, places) if return_locations else (tri, ray)

    def intersects_location(self, ray_origins, ray_directions, multiple_hits=True, **_):
        """Places (H, 3), rays (H) and faces (H) of all hits, or of the nearest of each ray."""
        tri, ray, places = self._hits(ray_origins, ray_directions, None if multiple_hits else 1)
        return places, ray, tri

    def intersects_first(self, ray_origins, ray_directions, **_):
        """The nearest face of each ray: int64 (N), -1 where nothing is hit."""
        face = cast(self._posed(), ray_origins, ray_directions, caster=self._caster)["triangle"]
        return np.where(face == 0xFFFFFFFF, -1, face.astype(np.int64))

    def intersects_any(self, ray_origins, ray_directions, **_):
        """Whether each ray hits anything: bool (N)."""
        return occluded(self._posed(), ray_origins, ray_directions, caster=self._caster)

    def contains_points(self, points):
        """Whether points are inside of a closed mesh: bool (N)."""
        points = to_numpy(points)
        hits = all_hits(self._posed(), points, np.array([0.1, 0.9, 0.42]), caster=self._caster)
        return np.diff(hits["first"]) % 2 == 1

    def _hits(self, origins, directions, most):
        origins, directions = to_numpy(origins, np.float64), to_numpy(directions, np.float64)
        if most == 1:
            hits = cast(self._posed(), origins, directions, caster=self._caster)
            ray = np.flatnonzero(hits["triangle"] != 0xFFFFFFFF)
            tri, t = hits["triangle"][ray], hits["t"][ray]
        else:
            hits = all_hits(self._posed(), origins, directions, caster=self._caster)
            ray, tri, t = hits["ray"], hits["triangle"], hits["t"]
            if most is not None:
                kept = np.arange(len(ray)) - hits["first"][ray] < most
                ray, tri, t = ray[kept], tri[kept], t[kept]
        places = origins[ray] + t[:, None].astype(np.float64) * directions[ray]
        return tri.astype(np.int64), ray.astype(np.int64), places

    def _posed(self):
        """The mesh as it is: made again where its arrays are other ones or have other numbers."""
        vertices, faces = to_numpy(self.mesh.vertices), to_numpy(self.mesh.faces)
        if self._world is None or not (np.array_equal(vertices, self._made_of[0]) and
                                       np.array_equal(faces, self._made_of[1])):
            self._made_of = vertices.copy(), faces.copy()
            self._world = _core.Scene(vertices, faces, normals=np.tile([0.0, 0, 1], (len(vertices), 1))).pose()
        return self._world


def _add(builder, mesh, name, smooth, material):
    vertices, faces = to_numpy(mesh.vertices), to_numpy(mesh.faces)
    visual = getattr(mesh, "visual", None)
    kind = getattr(visual, "kind", None)
    uv = colors = None
    paint = material
    if material is None and kind == "vertex":
        colors = to_numpy(visual.vertex_colors)
        paint = _core.Material(name=name, color=(1, 1, 1))
    elif material is None and kind == "texture":
        paint = _material(getattr(visual, "material", None), name)
        uv = getattr(visual, "uv", None)
        uv = None if uv is None else to_numpy(uv)
    elif material is None and kind == "face":
        # A colour for each face needs corners of its own.
        colors = np.repeat(to_numpy(visual.face_colors), 3, axis=0)
        vertices, faces = vertices[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3)
        paint = _core.Material(name=name, color=(1, 1, 1))
        smooth = False
    number = builder.add_mesh(vertices, faces, normals=to_numpy(mesh.vertex_normals) if smooth else None, uv=uv,
                              colors=colors, name=name)
    return number, builder.add_material(paint or _core.Material(name=name))


def _material(of, name):
    """trimesh.visual.material's SimpleMaterial (diffuse, image) or PBRMaterial (baseColorFactor, baseColorTexture)."""
    image = getattr(of, "image", None)
    if image is None:
        image = getattr(of, "baseColorTexture", None)
    linear = (1.0, 1.0, 1.0) if image is not None else (0.8, 0.8, 0.8)
    if getattr(of, "baseColorFactor", None) is not None:
        linear = _share(of.baseColorFactor)
    elif getattr(of, "diffuse", None) is not None:
        linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in _share(of.diffuse)]
    return _core.Material(name=getattr(of, "name", None) or name, color=linear,
                          texture=None if image is None else _rgb(image))


def _share(color):
    """Three numbers from 0 to 1; whole numbers are 0 to 255."""
    values = to_numpy(color)[:3]
    return (values / 255 if values.dtype.kind in "iu" else values).astype(float)


def _rgb(image):
    pixels = to_numpy(image.convert("RGB") if hasattr(image, "convert") else image)
    return np.repeat(pixels[:, :, None], 3, axis=2) if pixels.ndim == 2 else pixels[:, :, :4]
