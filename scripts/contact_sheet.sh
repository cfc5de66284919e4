#!/usr/bin/env bash
# contact_sheet.sh - pictures of ten models at the defaults of Firsthit (left) and of F3D (right), in one PNG.
#
# Usage: contact_sheet.sh OUT.png [FILE...]; without files the bunny, the dragon and what tools/sample_models.py writes.
# Needs the Debian packages f3d, xvfb and ffmpeg. FIRSTHIT names another program than build/release/bin/firsthit.
set -euo pipefail
out=$(realpath -m -- "${1:?usage: contact_sheet.sh OUT.png [FILE...]}")
shift
files=()
for file in "$@"; do files+=("$(realpath -- "$file")"); done
cd -- "$(dirname -- "$0")/.."

firsthit=${FIRSTHIT:-build/release/bin/firsthit}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [ ${#files[@]} -eq 0 ]; then
    python3 tools/sample_models.py "$work/models"
    for name in bracket.stl ball.stl heat.ply crate.obj spheres.gltf leaves.gltf wheel.gltf town.ply; do
        files+=("$work/models/$name")
    done
    files=(scenes/bunny.stl scenes/dragon.ply "${files[@]}")
fi

size=480x360 columns=2 inputs=() layout=() labels=
for k in "${!files[@]}"; do
    file=${files[k]}
    "$firsthit" render "$file" -o "$work/$k.a.png" --size "$size" 2>>"$work/errors" || cat "$work/errors" >&2
    xvfb-run -a f3d "$file" --output="$work/$k.b.png" --resolution="${size/x/,}" >"$work/f3d.log" 2>&1 ||
        cat "$work/f3d.log" >&2
    for side in a b; do
        inputs+=(-i "$work/$k.$side.png")
        y=$((360 * (k / columns)))
        if [ "$side" = b ]; then x=$((480 * (k % columns * 2 + 1))); else x=$((960 * (k % columns))); fi
        layout+=("${x}_$y")
    done
done
count=$((2 * ${#files[@]}))
for ((k = 0; k < count; ++k)); do labels+="[$k:v]format=rgb24[v$k];"; done
for ((k = 0; k < count; ++k)); do labels+="[v$k]"; done
layout=$(IFS='|'; echo "${layout[*]}")
ffmpeg -v error -y "${inputs[@]}" -filter_complex "${labels}xstack=inputs=$count:layout=$layout:fill=white" \
    -frames:v 1 "$out"
