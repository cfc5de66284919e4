#!/usr/bin/env bash
# tsan.sh - the tests of what shares threads, under the thread sanitizer: loops on threads, the renderer,
# occlusion, and the hybrid engine with OpenGL's thread. Only their programs are built; the kernels for one
# instruction set (the preset tsan), because races do not depend on it.
set -euo pipefail
cd -- "$(dirname -- "$0")/.."

scripts/build.sh tsan -- base_test render_test engines_test
source scripts/test_environment.sh
export EGL_PLATFORM=${EGL_PLATFORM:-surfaceless}
log=build/tsan-tests.log
ctest --preset tsan -j "$(nproc)" --no-tests=error \
    -R '^(Tasks|Renderer|Occlusion)\.|^Engines\.(Hybrid|Make|Upload)' >"$log" 2>&1 || {
    tail -n 200 "$log"
    exit 1
}
tail -n 8 "$log"
