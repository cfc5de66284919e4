#!/usr/bin/env bash
# build.sh - configures and builds a preset quietly.
# Usage: build.sh PRESET [CMAKE_OPTION...] [-- TARGET...]; without a target it builds everything.
# What the tools say is in build/PRESET.log, and on the terminal where they fail.
set -euo pipefail
cd -- "$(dirname -- "$0")/.."

preset=${1:?usage: build.sh PRESET [CMAKE_OPTION...] [-- TARGET...]}
shift
options=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    options+=("$1")
    shift
done
targets=()
if [ $# -gt 1 ]; then targets=(--target "${@:2}"); fi
log=build/$preset.log
mkdir -p build

if command -v ccache >/dev/null; then
    options+=(-D CMAKE_CXX_COMPILER_LAUNCHER=ccache)
    # Without these two it does not keep what is compiled with precompiled headers.
    export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
fi

echo "building the preset $preset"
{
    cmake --preset "$preset" "${options[@]}" &&
        cmake --build --preset "$preset" -j "$(nproc)" "${targets[@]}"
} >"$log" 2>&1 || {
    grep -n -m 20 -E 'error|Error|FAILED' "$log" >&2 || true
    tail -n 20 "$log" >&2
    echo "build.sh: the preset $preset does not build; all of it is in $log" >&2
    exit 1
}
