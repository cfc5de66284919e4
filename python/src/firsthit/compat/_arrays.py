"""Arrays of other libraries."""

import numpy as np


def to_numpy(array, dtype=None):
    """A NumPy array of whatever holds one: also Open3D's and PyTorch's tensors."""
    if hasattr(array, "detach"):
        array = array.detach().cpu()
    if hasattr(array, "numpy"):
        array = array.numpy()
    return np.asarray(array, dtype)
