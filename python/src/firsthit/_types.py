"""Types of arguments."""

from typing import Sequence, Tuple

import numpy as np
import numpy.typing as npt

Array = npt.ArrayLike
"""What NumPy makes an array of; objects with __dlpack__ are taken too."""
Floats = npt.NDArray[np.float64]
Size = Tuple[int, int]
Color = Sequence[float]
