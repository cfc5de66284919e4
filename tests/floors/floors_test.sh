#!/usr/bin/env bash
# floors_test.sh - the checker of floors finds what it is there for. Usage: floors_test.sh CHECKER
set -uo pipefail
checker=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

# sample CODE FILE LINE [NAMED]: a project of one line, and of the empty files $texts, passes (0) or fails (1)
# at that line, or at file NAMED.
texts=
sample()
{
    local code=$1 file=$2 line=$3 named=${4:-$2} actual=0 out text
    rm -rf "$folder/project"
    mkdir -p "$folder/project/src" "$folder/project/$(dirname "$file")"
    for text in $texts; do
        mkdir -p "$folder/project/$(dirname "$text")"
        echo '// a text' >"$folder/project/$text"
    done
    printf '// first line\n%s\n' "$line" >"$folder/project/$file"
    out=$("$checker" "$folder/project" 2>&1) || actual=1
    if [ "$actual" -ne "$code" ]; then
        echo "FAILED: '$line' in $file: exit code $actual, not $code: $out"
        failures=$((failures + 1))
    elif [ "$code" -eq 1 ] && ! grep -q "^$named:" <<<"$out"; then
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

# Public headers: data and options everywhere, settings from the engines up, the rest in render/.
for header in error file film frame_control npy scene stats texture view options/shadow_options; do
    sample 0 src/base/a.h "#include <firsthit/$header.h>"
done
sample 0 src/cpu/a.h '#include <firsthit/settings.h>'
sample 0 src/gl/a.h '#include <firsthit/settings.h>'
sample 0 src/baseline/a.h '#include <firsthit/settings.h>'
sample 1 src/shadow/a.h '#include <firsthit/settings.h>'
sample 1 src/hits/a.h '#include <firsthit/settings.h>'
for header in render compare baseline occlusion firsthit; do
    sample 0 src/render/a.h "#include <firsthit/$header.h>"
    for floor in base hits shadow cpu gl baseline; do
        sample 1 "src/$floor/a.h" "#include <firsthit/$header.h>"
    done
done
sample 1 src/hits/a.h '#include <firsthit/options/deeper/a.h>'
sample 0 include/firsthit/scene.h '#include <firsthit/view.h>'
sample 1 include/firsthit/scene.h '#include <firsthit/settings.h>'
sample 1 include/firsthit/film.h '#include <firsthit/options/shadow_options.h>'
sample 0 include/firsthit/options/a.h '#include <firsthit/options/b.h>'
sample 1 include/firsthit/options/a.h '#include <firsthit/settings.h>'
sample 1 include/firsthit/options/a.h '#include <firsthit/render.h>'

# Shaders: texts have names of their own, and lie below who includes them.
texts="src/glsl/power.glsl src/gl/shaders/frame.glsl"
sample 0 src/gl/shaders/a.frag '#include "power.glsl"'
sample 0 src/gl/shaders/a.comp '#include "frame.glsl"'
sample 0 src/glsl/a.glsl '#include "power.glsl"'
sample 1 src/glsl/a.glsl '#include "frame.glsl"'
for ending in vert frag geom comp; do sample 1 "src/glsl/a.$ending" '#include "frame.glsl"'; done
sample 1 src/gl/shaders/a.vert '#include "missing.glsl"'
sample 1 src/gl/shaders/a.vert '#include "glsl/nothing.glsl"'
sample 1 src/gl/shaders/a.vert '#include "../../glsl/power.glsl"'
texts="src/glsl/power.glsl src/gl/shaders/items/a.frag"
sample 1 src/gl/shaders/a.frag 'void main() {}' src/gl/shaders/items/a.frag
texts=

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
