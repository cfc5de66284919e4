#!/usr/bin/env bash
# check_tidy.sh - clang-tidy, with the checks of .clang-tidy, over what it can read in reasonable time: the
# public headers, files, scenes, the frame, the renderer, the program and the examples.
# Usage: check_tidy.sh [FILE...]
# Left out by rule: kernels, which include themselves four times by Highway (foreach_target.h) and take half
# a minute each, and what lies on them; they are compiled with -Wconversion and run under sanitizers.
set -euo pipefail
cd -- "$(dirname -- "$0")/.."

tidy=${CLANG_TIDY:-clang-tidy-14}
command -v "$tidy" >/dev/null || {
    echo "check_tidy.sh: $tidy is missing: apt-get install clang-tidy-14" >&2
    exit 1
}
# Configured alone, nothing is built: clang cannot read what g++ precompiles.
cmake --preset release -B build/tidy -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null

if [ $# -gt 0 ]; then
    files=("$@")
else
    mapfile -t files < <(
        find src/io src/film src/frame src/scene/model src/cpu src/render apps/firsthit examples -maxdepth 1 -name '*.cpp' |
            xargs grep -L 'foreach_target\.h' | sort
    )
fi
log=build/tidy.log
# clang does not know g++'s options: it is told not to mind.
printf '%s\0' "${files[@]}" | xargs -0 -r -n 1 -P "$(nproc)" "$tidy" -p build/tidy --quiet \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-ignored-optimization-argument >"$log" 2>"$log.err" || {
    cat "$log" >&2
    grep -E 'error' "$log.err" >&2 || true
    echo "check_tidy.sh: clang-tidy has something to say (all of it is in $log)" >&2
    exit 1
}
echo "tidy: ${#files[@]} files are as they should be"
