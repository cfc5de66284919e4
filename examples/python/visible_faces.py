"""Which triangles of a model cameras see, as texturing from photographs needs it.

    python3 visible_faces.py [SCENE]
"""

import sys

import numpy as np

import firsthit as fh

world = fh.load(sys.argv[1] if len(sys.argv) > 1 else "builtin:torus").pose()
cameras = fh.turntable(world, 24, size=(512, 512)) + [fh.framing(world, v, size=(512, 512)) for v in ("top", "bottom")]
pixels = fh.visible(world, cameras)
print(f"{np.count_nonzero(pixels)} of {len(pixels)} triangles are seen; the best one by {pixels.max()} pixels of all views")
assert np.count_nonzero(pixels) > 0
