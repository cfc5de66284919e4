"""Thin stand-ins for what other libraries offer, with their names and conventions.

    from firsthit.compat.open3d import RaycastingScene
    from firsthit.compat.pyrender import OffscreenRenderer
    from firsthit.compat.nvdiffrast import rasterize
    from firsthit.compat.trimesh import RayMeshIntersector, scene_of

None of them imports the library that it stands in for: objects are taken by what they have. Each says what it leaves out.
"""
