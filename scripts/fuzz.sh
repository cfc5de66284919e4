#!/usr/bin/env bash
# fuzz.sh - builds the fuzz targets and runs each for a while. Usage: fuzz.sh SECONDS [NAME...]
# A finding is left in build/fuzz/findings/ and fails the run; run the target on it to see it again.
set -euo pipefail
cd -- "$(dirname -- "$0")/.."

seconds=${1:?usage: fuzz.sh SECONDS [NAME...]}
shift
scripts/build.sh fuzz
targets=build/fuzz/fuzz
[ "$#" -gt 0 ] || set -- $(ls "$targets")
mkdir -p build/fuzz/findings

# fuzz NAME : one target, from the seeds and what earlier runs found.
fuzz()
{
    local name=$1
    local corpus=build/fuzz/corpus/$name
    mkdir -p "$corpus"
    "$targets/$name" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 -max_len=8192 \
        -artifact_prefix="build/fuzz/findings/$name-" -print_final_stats=1 \
        "$corpus" "tests/fuzz/seeds/$name" >"build/fuzz/$name.log" 2>&1 || {
        tail -n 40 "build/fuzz/$name.log" >&2
        echo "fuzz.sh: $name found something: build/fuzz/findings/$name-*" >&2
        return 1
    }
    echo "$name: $(awk '/number_of_executed_units/ { print $2 }' "build/fuzz/$name.log") runs, nothing found"
}

# As many at a time as there are cores.
running=0
failed=0
for name in "$@"; do
    if [ "$running" -ge "$(nproc)" ]; then
        wait -n || failed=1
        running=$((running - 1))
    fi
    fuzz "$name" &
    running=$((running + 1))
done
while [ "$running" -gt 0 ]; do
    wait -n || failed=1
    running=$((running - 1))
done
exit "$failed"
