"""Builds the package by CMake: see pyproject.toml.

FIRSTHIT_PREFIX  where the library is installed already (cmake --install build/release --prefix ...): it is used and not built
"""

import os
import pathlib
import re

from skbuild import setup

root = pathlib.Path(__file__).resolve().parent
prefix = os.environ.get("FIRSTHIT_PREFIX")
version = re.search(r"project\(firsthit VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text()).group(1)

setup(
    version=version,
    packages=["firsthit", "firsthit.compat"],
    package_dir={"": "python/src"},
    package_data={"firsthit": ["py.typed", "*.pyi"]},
    include_package_data=False,
    cmake_source_dir="python" if prefix else ".",
    cmake_install_dir="python/src/firsthit",
    cmake_with_sdist=False,
    cmake_args=["-DCMAKE_BUILD_TYPE=Release"] + (
        [f"-DCMAKE_PREFIX_PATH={prefix}"] if prefix else
        ["-DFIRSTHIT_BUILD_PYTHON=ON", "-DFIRSTHIT_BUILD_TESTS=OFF", "-DFIRSTHIT_BUILD_APPS=OFF"]),
)
