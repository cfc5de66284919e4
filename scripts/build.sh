#!/usr/bin/env bash
# build.sh - configures and builds a preset quietly. Usage: build.sh PRESET [CMAKE_OPTION...]
# What the tools say is in build/PRESET.log, and on the terminal where they fail.
set -euo pipefail
cd -- "$(dirname -- "$0")/.."

preset=${1:?usage: build.sh PRESET [CMAKE_OPTION...]}
shift
log=build/$preset.log
mkdir -p build

options=("$@")
if command -v ccache >/dev/null; then options+=(-D CMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

echo "building the preset $preset"
{
    cmake --preset "$preset" "${options[@]}" &&
        cmake --build --preset "$preset" -j "$(nproc)"
} >"$log" 2>&1 || {
    grep -n -m 20 -E 'error|Error|FAILED' "$log" >&2 || true
    tail -n 20 "$log" >&2
    echo "build.sh: the preset $preset does not build; all of it is in $log" >&2
    exit 1
}
