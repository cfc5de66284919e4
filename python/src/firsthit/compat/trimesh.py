"""Scenes of trimesh's meshes and scenes, taken by what they have: vertices, faces, visual, geometry, graph."""

import numpy as np

from .. import _firsthit as _core
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
