#!/usr/bin/env bash
# wheel_test.sh - the wheel, where nothing of this project is installed: in a fresh virtual environment, and in a bare Debian that
# has NumPy and no library of ours. Skipped (exit code 77) where what makes the wheel is missing; without the bare Debian, and
# saying so, where debootstrap, its archive or root's rights are missing.
# Usage: wheel_test.sh BUILD_FOLDER PYTHON
set -euo pipefail
build=$(realpath "$1")
python=$2
project=$(realpath "$(dirname -- "$0")/../..")

skip()
{
    echo "skipped: $1"
    exit 77
}

command -v patchelf >/dev/null || skip "there is no patchelf"
for module in skbuild wheel pip venv pybind11; do "$python" -c "import $module" 2>/dev/null || skip "there is no $module"; done
work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
cd "$work"

cmake --install "$build" --prefix prefix --component development >install.log
PYTHON=$python "$project/scripts/build_wheel.sh" wheel prefix
wheel=$(ls "$work"/wheel/*.whl)

# Of the system it needs the libraries of C and C++.
mkdir unpacked
"$python" -m zipfile -e "$wheel" unpacked
find unpacked -name '*.so*' -exec patchelf --print-needed {} + | sort -u >needed
if grep -v -E '^(libc|libm|libdl|libpthread|librt|libstdc\+\+|libgcc_s|ld-linux-x86-64)\.so\.[0-9]+$|^lib.*-[0-9a-f]{8}\.so' needed; then
    echo "FAILED: the wheel needs these libraries of the system"
    exit 1
fi

# What is done with it: the bytes of a picture.
cat >use.py <<'END'
import firsthit as fh

world = fh.load("builtin:robots").pose(2)
frame = fh.render(world, fh.scene_camera(world, size=(160, 120)), ["color", "depth", "instance"])
assert frame["color"].any() and (frame["instance"] != fh.NO_ID).any()
print(frame.hash())
END
PYTHONPATH=$build/python "$python" use.py >wanted

# A virtual environment without the system's packages, and with NumPy.
"$python" -m venv fresh
numpy=$("$python" -c "import numpy, pathlib; print(pathlib.Path(numpy.__file__).parent)")
cp -r "$numpy" fresh/lib/python3*/site-packages/
fresh/bin/pip install --quiet --no-index --no-deps "$wheel"
env -u PYTHONPATH LD_DEBUG=libs LD_DEBUG_OUTPUT=loaded fresh/bin/python use.py >got
cmp got wanted
if cat loaded.* | grep -E 'calling init: .*/lib(png16|OpenEXR|assimp|embree3|epoxy|hwy|draco|fmt)[^/]*$' | grep -v firsthit.libs; then
    echo "FAILED: libraries of the system were loaded"
    exit 1
fi
echo "the wheel works in a fresh virtual environment"

# A bare Debian.
alone()
{
    echo "not tried in a bare Debian: $1"
    exit 0
}
for program in debootstrap chroot; do command -v $program >/dev/null || alone "there is no $program"; done
[ "$(id -u)" -eq 0 ] || alone "only root can make one"
grep -q '^VERSION_CODENAME=bookworm' /etc/os-release || alone "this is another system"
mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | \
    sed -n 's/^\(deb\|URIs:\) *\(\[[^]]*\] *\)\?\(http[^ ]*\).*/\3/p' | grep -v security | head -n 1 || true)
debootstrap --variant=minbase --include=python3-minimal,python3-numpy bookworm root "${mirror:-http://deb.debian.org/debian}" \
    >debootstrap.log 2>&1 || { tail -n 3 debootstrap.log; alone "debootstrap cannot make one here"; }
mkdir root/opt/wheel
cp -r unpacked/. root/opt/wheel/
cp use.py root/opt/
for library in libpng16 libOpenEXR libassimp libembree3 libepoxy libhwy; do
    if ls root/usr/lib/*/$library* >/dev/null 2>&1; then echo "FAILED: the bare Debian has $library"; exit 1; fi
done
chroot root env PYTHONPATH=/opt/wheel python3 /opt/use.py >got
cmp got wanted
echo "the wheel works in a bare Debian"
