#!/usr/bin/env bash
# build_wheel.sh - a wheel of the Python package that needs no library of the system but those of C and C++: all others are
# in it. OpenGL is opened while it runs, where there is one. Needs Debian's python3-skbuild, python3-wheel and patchelf.
# Usage: build_wheel.sh [FOLDER [PREFIX]]. FOLDER: where the wheel goes, dist by default. PREFIX: where the library is installed,
# by cmake --install; without it the library is built too, in the folder's build/.
set -euo pipefail
project=$(realpath "$(dirname -- "$0")/..")
folder=$(realpath -m "${1:-$project/dist}")
python=${PYTHON:-/usr/bin/python3}
for module in skbuild wheel pip pybind11; do
    "$python" -c "import $module" 2>/dev/null || {
        echo "build_wheel.sh: $python has no $module: apt-get install python3-skbuild python3-wheel python3-pip python3-pybind11" >&2
        exit 1
    }
done
command -v patchelf >/dev/null || { echo "build_wheel.sh: there is no patchelf: apt-get install patchelf" >&2; exit 1; }

# Building leaves files beside the sources, so it does not happen there.
mkdir -p "$folder/build"
source=$folder/build/source
rm -rf "$source/python"
mkdir -p "$source"
cp -r "$project/python" "$source/"
for name in CMakeLists.txt pyproject.toml setup.py LICENSE cmake docs include src; do ln -sfn "$project/$name" "$source/$name"; done
if [ -n "${2:-}" ]; then
    FIRSTHIT_PREFIX=$(realpath "$2")
    export FIRSTHIT_PREFIX
fi
rm -rf "$folder/build/plain"
"$python" -m pip wheel "$source" --quiet --no-build-isolation --no-deps --no-index --wheel-dir "$folder/build/plain" \
    >"$folder/build/log" 2>&1 || {
    tail -n 30 "$folder/build/log" >&2
    echo "build_wheel.sh: the package does not build; all of it is in $folder/build/log" >&2
    exit 1
}
"$python" "$project/tools/bundle_wheel.py" "$folder"/build/plain/firsthit-*.whl "$folder"
