#!/usr/bin/env bash
# msan.sh - makes frames of all kinds under MemorySanitizer: what they read must have been written.
# Clang only, the cpu engine only; what it says is in build/msan/frames.log.
set -euo pipefail
cd -- "$(dirname -- "$0")/.."

scripts/build.sh msan
log=build/msan/frames.log
build/msan/tests/msan/msan_frames >"$log" 2>&1 || {
    tail -n 60 "$log" >&2
    echo "msan.sh: a frame reads memory that nobody wrote; all of it is in $log" >&2
    exit 1
}
tail -n 1 "$log"
