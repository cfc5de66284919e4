#!/usr/bin/env bash
# install_packages.sh - the Debian 12 packages that a job needs; skips what is there.
# Usage: install_packages.sh [build] [test] [ci] [wheel] [scenes]. Without a word: build.
set -euo pipefail

build="git cmake ninja-build g++ libhwy-dev libglm-dev libembree-dev libpng-dev
    libopenexr-dev libcli11-dev libfmt-dev libgtest-dev libbenchmark-dev libstb-dev
    nlohmann-json3-dev libassimp-dev libdraco-dev libmeshoptimizer-dev libwebp-dev libjpeg-dev
    libepoxy-dev libegl1 libgl1 libgl1-mesa-dri libglfw3-dev libimgui-dev libboost-dev python3 python3-dev pybind11-dev
    python3-numpy python3-pytest"
test="xvfb ffmpeg libgmp-dev make python3-distributed"
wheel="python3-pip python3-venv python3-wheel python3-skbuild python3-pybind11 patchelf"
ci="clang-format-14 clang-tidy-14 doxygen clang-14 libclang-rt-14-dev glslang-tools ffmpeg pkg-config"
scenes="npm ca-certificates"

needed=""
for job in "${@:-build}"; do
    case "$job" in
        build) needed+=" $build" ;;
        test) needed+=" $test" ;;
        ci) needed+=" $ci" ;;
        wheel) needed+=" $wheel" ;;
        scenes) command -v npm >/dev/null || needed+=" $scenes" ;;
        *) echo "usage: install_packages.sh [build] [test] [ci] [wheel] [scenes]" >&2; exit 2 ;;
    esac
done

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "install_packages.sh: no apt-get here; these Debian packages are needed:" $needed >&2
    exit 0 # they may be there under other names: let the configuration say what is missing
fi

missing=()
for package in $needed; do
    state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || missing+=("$package")
done
[ "${#missing[@]}" -gt 0 ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
    as_root=()
elif command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
    as_root=(sudo)
else
    echo "install_packages.sh: packages are missing, and only root or sudo can install them. Run:" >&2
    echo "  apt-get install ${missing[*]}" >&2
    exit 1
fi

echo "installing ${#missing[@]} packages: ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
install()
{
    # `env` because sudo does not pass the variable on.
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -q --no-install-recommends "${missing[@]}" >"$log" 2>&1
}
# The list of packages may be old or absent: then it is fetched and the installation tried again.
if ! install; then
    "${as_root[@]}" apt-get update -q >"$log" 2>&1 && install || {
        tail -n 20 "$log" >&2
        echo "install_packages.sh: cannot install: ${missing[*]}" >&2
        exit 1
    }
fi
