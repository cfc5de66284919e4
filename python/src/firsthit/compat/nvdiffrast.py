"""nvdiffrast's rasterize, forward.

    out, _ = rasterize(None, pos, tri, resolution=(480, 640))
    u, v, z_over_w, id_plus_1 = out[0, row].T       # row 0 is at the bottom

Arrays are NumPy's in the place of PyTorch's tensors, which are taken too. There are no gradients and no ranges: rast_db has no
channels. Which triangle a pixel sees is found on float32 positions, exactly; u, v and z/w are computed in float64.
"""

import numpy as np

from .. import _firsthit as _core
from ..cameras import from_opencv
from ..rendering import render
from ._arrays import to_numpy


def rasterize(glctx, pos, tri, resolution, ranges=None, grad_db=False):
    """The triangle at the centre of each pixel: float32 (B, H, W, 4) with u, v, z/w and triangle id + 1, and an empty rast_db.

    glctx       nothing is looked at
    pos         (B, V, 4) or (V, 4), clip space: a pixel sees x/w, y/w of -1 to 1, and z/w of -1 (near) to 1
    tri         (T, 3)
    resolution  (height, width)
    u, v are the weights of corners 0 and 1; pixels that see nothing are 0
    """
    if ranges is not None or grad_db:
        raise NotImplementedError("rasterize: ranges and grad_db=True are not there")
    batch = to_numpy(pos, np.float32)
    if batch.ndim == 2:
        batch = batch[None]
    if batch.ndim != 3 or batch.shape[2] != 4:
        raise ValueError(f"pos: got {batch.dtype} {batch.shape}, wanted float32 (B, V, 4)")
    triangles = to_numpy(tri)
    if triangles.ndim != 2 or triangles.shape[1] != 3 or triangles.dtype.kind not in "iu":
        raise ValueError(f"tri: got {triangles.dtype} {triangles.shape}, wanted int32 (T, 3)")
    if not np.isfinite(batch).all():
        raise ValueError("pos: a coordinate is not finite")
    if len(triangles) >= 2**24:
        raise ValueError(f"tri: {len(triangles)} triangles: at most 16777215 have ids that float32 can tell apart")
    if triangles.size and not (0 <= triangles.min() and triangles.max() < batch.shape[1]):
        raise ValueError(f"tri: an index is out of range: there are {batch.shape[1]} vertices")
    height, width = resolution
    out = np.zeros((len(batch), height, width, 4), np.float32)
    for corners, picture in zip(batch.astype(np.float64), out):
        item = _items(corners, triangles, (width, height))
        _fill(corners, triangles, item, picture)
    return out, np.zeros(out.shape[:3] + (0,), np.float32)


def _items(vertices, triangles, size):
    """The triangle of each pixel, the bottom row first."""
    x, y, z, w = vertices.T
    points, index, origin = None, triangles, np.arange(len(triangles))
    used = np.zeros(len(vertices), bool)
    used[triangles] = True
    line = np.linalg.lstsq(np.stack([w[used], np.ones(used.sum())], 1), z[used], rcond=None)[0]
    plain = np.abs(line[0] * w[used] + line[1] - z[used]).max(initial=0) <= 1e-5 * np.abs(z[used]).max(initial=0)
    inside = (np.abs(z) <= w)[used].all()
    if plain and inside and line[1] < 0:
        # A perspective picture whose depth grows with w: (x, y, w) are coordinates of the camera.
        points = np.stack([x, y, w], -1)
    else:
        # The projective map that takes lines along z to lines through the eye; it needs what is clipped at z = -w, w.
        vertices, index, origin = _clipped(vertices, triangles)
        x, y, z, w = vertices.T
        points = np.stack([x, y, w], -1) / np.where(2 * w - z > 0, 2 * w - z, 1)[:, None]
    width, height = size
    # x/w of -1 to 1 is the picture's width; y/w grows with rows, as row 0 is at the bottom.
    k = [[width / 2, 0, width / 2], [0, height / 2, height / 2], [0, 0, 1]]
    world = _core.Scene(points, index, normals=np.tile([0.0, 0, 1], (len(points), 1)), studio=False).pose()
    item = np.array(render(world, from_opencv(k, np.eye(4), size, pixel_center=0.5), ["item"])["item"], np.int64)
    seen = item != 0xFFFFFFFF
    item[~seen] = -1
    item[seen] = origin[item[seen]]
    return item


def _clipped(vertices, triangles):
    """Triangles cut at z = -w and z = w, and which triangle each is of."""
    z, w = vertices[:, 2], vertices[:, 3]
    whole = (np.abs(z) <= w)[triangles].all(1) & (w > 0)[triangles].all(1)
    gone = (z < -w)[triangles].all(1) | (z > w)[triangles].all(1)
    points, index, origin = [vertices], [triangles[whole]], [np.nonzero(whole)[0]]
    count = len(vertices)
    for t in np.nonzero(~whole & ~gone)[0]:
        polygon = list(vertices[triangles[t]])
        for side in (1, -1):
            away = [side * p[2] + p[3] for p in polygon]
            cut = []
            for k, (p, d) in enumerate(zip(polygon, away)):
                q, e = polygon[k - 1], away[k - 1]
                if (d >= 0) != (e >= 0):
                    # From what stays to what goes, so that neighbours get the same point.
                    (stay, a), (go, b) = ((p, d), (q, e)) if d >= 0 else ((q, e), (p, d))
                    cut.append(stay + (go - stay) * (a / (a - b)))
                if d >= 0:
                    cut.append(p)
            polygon = cut
        polygon = [p for p in polygon if p[3] > 0]
        for k in range(2, len(polygon)):
            points.append(np.array([polygon[0], polygon[k - 1], polygon[k]]))
            index.append(np.array([[count, count + 1, count + 2]]))
            origin.append([t])
            count += 3
    vertices, index, origin = np.concatenate(points), np.concatenate(index), np.concatenate(origin).astype(int)
    # What no triangle uses may lie anywhere.
    used = np.zeros(len(vertices), bool)
    used[index] = True
    vertices[~used] = [0, 0, 0, 1]
    return vertices, index, origin


def _fill(vertices, triangles, item, picture):
    """u, v, z/w and id + 1 of pixels that see something."""
    row, column = np.nonzero(item >= 0)
    if not len(row):
        return
    height, width = item.shape
    at = np.stack([(column + 0.5) * 2 / width - 1, (row + 0.5) * 2 / height - 1, np.ones(len(row))], -1)
    corners = vertices[triangles[item[row, column]]]
    # The point is the sum of weights times corners, up to a factor: (x, y, w) of the sum is the pixel's.
    m = corners[:, :, [0, 1, 3]]
    weight = np.stack([np.einsum("ij,ij->i", at, np.cross(m[:, (k + 1) % 3], m[:, (k + 2) % 3])) for k in range(3)], -1)
    weight /= weight.sum(1, keepdims=True)
    weight = np.clip(weight, 0, 1)
    z, w = (np.einsum("ij,ij->i", weight, corners[:, :, k]) for k in (2, 3))
    picture[row, column] = np.stack([weight[:, 0], weight[:, 1], z / w, item[row, column] + 1.0], -1)
