#!/usr/bin/env bash
# floors_test.sh - the checker of floors finds what it is there for. Usage: floors_test.sh CHECKER
set -uo pipefail
checker=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

# sample CODE FILE LINE : a project of one line passes (0) or fails (1) at that line.
sample()
{
    local code=$1 file=$2 line=$3 actual=0 out
    rm -rf "$folder/project"
    mkdir -p "$folder/project/src" "$folder/project/$(dirname "$file")"
    printf '// first line\n%s\n' "$line" >"$folder/project/$file"
    out=$("$checker" "$folder/project" 2>&1) || actual=1
    if [ "$actual" -ne "$code" ]; then
        echo "FAILED: '$line' in $file: exit code $actual, not $code: $out"
        failures=$((failures + 1))
    elif [ "$code" -eq 1 ] && ! grep -q "^$file:" <<<"$out"; then
        echo "FAILED: '$line' in $file is not named in: $out"
        failures=$((failures + 1))
    fi
}

# Down, to itself, to the public headers and to libraries.
sample 0 src/hits/a.h '#include "visibility/b.h"'
sample 0 src/render/a.cpp '#include "base/b.h"'
sample 0 src/render/a.cpp '#include "baseline/b.h"'
sample 0 src/baseline/a.cpp '#include "cpu/b.h"'
sample 0 src/scene/a.cpp '#include "scene/b.h"'
sample 0 src/scene/a.cpp '#include <firsthit/scene.h>'
sample 0 src/film/a.cpp '#include <png.h>'
sample 0 include/firsthit/a.h '#include <firsthit/b.h>'
sample 0 apps/firsthit/a.cpp '#include "b.h"'
sample 0 apps/firsthit/a.cpp '#include <firsthit/scene.h>'
sample 0 apps/firsthit/bench/a.cpp '#include "bench/b.h"'
sample 0 tests/consumer/a.cpp '#include <firsthit/scene.h>'
sample 0 'src/film/with a space.cpp' '#include "film/b.h"'
sample 0 src/scene/a.cpp '// #include "render/b.h" is only spoken of'

# Up, sideways, around.
sample 1 src/hits/a.h '#include "shade/b.h"'
sample 1 src/base/a.h '#include "scene/b.h"'
sample 1 src/scene/a.cpp '#include "film/b.h"'
sample 1 src/cpu/a.cpp '#include "baseline/b.h"'
sample 1 src/baseline/a.cpp '#include "render/b.h"'
sample 1 src/scene/a.cpp '  #  include "render/b.h"  // why'
sample 1 src/shade/a-inl.h '#include <cpu/frame.h>'
sample 1 src/scene/a.cpp '#include "../render/b.h"'
sample 1 src/scene/a.cpp '#include "b.h"'
sample 1 src/attic/a.cpp '#include <vector>'
sample 1 include/firsthit/a.h '#include "base/b.h"'
sample 1 include/firsthit/a.h '#include <scene/track.h>'
sample 1 apps/firsthit/a.cpp '#include "scene/track.h"'
sample 1 apps/firsthit/a.cpp '#include <base/tasks.h>'
sample 1 apps/firsthit/bench/a.cpp '#include "cpu/frame.h"'
sample 1 apps/firsthit/a.cpp '#include "../../src/scene/track.h"'
sample 1 tests/consumer/a.cpp '#include "scene/track.h"'
sample 1 examples/a.cpp '#include "scene/track.h"'
sample 1 'src/film/with a space.cpp' '#include "cpu/b.h"'

echo "$failures failures"
[ "$failures" -eq 0 ]
