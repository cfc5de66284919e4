"""What several tests use."""

import os
import pathlib
import subprocess

import numpy as np
import pytest

import firsthit as fh


@pytest.fixture
def square():
    """Two triangles that fill a square of side 2 at z = 0."""
    return fh.Scene([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]])


@pytest.fixture
def front():
    """A camera 3 before the square, of 64 x 48 pixels."""
    return fh.look_at(eye=(0, 0, 3), target=(0, 0, 0), size=(64, 48))


@pytest.fixture(scope="session")
def robots():
    return fh.load("builtin:robots")


@pytest.fixture(scope="session")
def program():
    """Runs the program; skipped where it was not built."""
    path = os.environ.get("FIRSTHIT_PROGRAM", "")
    if not pathlib.Path(path).is_file():
        pytest.skip("FIRSTHIT_PROGRAM names no program")

    def run(*words, folder):
        subprocess.run([path, *map(str, words)], cwd=folder, check=True, capture_output=True)

    return run


@pytest.fixture(scope="session")
def bunny():
    """The path of the bunny; skipped where it was not fetched."""
    path = pathlib.Path(os.environ.get("FIRSTHIT_SCENES", "scenes")) / "bunny.stl"
    if not path.is_file():
        pytest.skip("scenes/bunny.stl is not there: scripts/fetch_scenes.sh")
    return str(path.resolve())


def random_mesh(seed, triangles=500):
    """Triangles of all sizes in a cube."""
    rng = np.random.default_rng(seed)
    corner = rng.uniform(-1, 1, (triangles, 1, 3))
    vertices = (corner + rng.uniform(-0.3, 0.3, (triangles, 3, 3))).reshape(-1, 3).astype(np.float32)
    return vertices, np.arange(3 * triangles).reshape(-1, 3)
