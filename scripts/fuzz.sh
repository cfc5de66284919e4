#!/usr/bin/env bash
# fuzz.sh - builds the fuzz targets and runs each for a while. Usage: fuzz.sh [SECONDS]; 60 by default
# A finding is left in build/fuzz/findings/ and fails the run; run the target on it to see it again.
set -euo pipefail
cd -- "$(dirname -- "$0")/.."

scripts/build.sh fuzz -D FIRSTHIT_FUZZ_SECONDS="${1:-60}"
log=build/fuzz/fuzz.log
ctest --test-dir build/fuzz/tests/fuzz -j "$(nproc)" --output-on-failure >"$log" 2>&1 || {
    tail -n 60 "$log" >&2
    echo "fuzz.sh: something was found; the inputs are in build/fuzz/findings/" >&2
    exit 1
}
grep -E 'Test +#[0-9]+' "$log"
