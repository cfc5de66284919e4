#!/usr/bin/env bash
# picture_hashes.sh - hashes of pictures and planes, to see whether a change leaves all bits alone.
#
# Usage: picture_hashes.sh PROGRAM [exact]
#   PROGRAM  the program `firsthit`
#   exact    only what has the same bits on every machine: planes of the built-in scenes by the cpu engine.
#            tests/pictures/exact_hashes.txt holds these; the test PictureHashes compares them
# Prints a line for each plane: sha256 (16 digits), scene, time, engine, shadows, plane. Takes the bunny from
# scenes/ and BART's robots from $FIRSTHIT_TEST_DATA, and leaves out what is not there; so it does with OpenGL.
set -euo pipefail
program=$(realpath -- "${1:?usage: picture_hashes.sh PROGRAM [exact]}")
kind=${2:-all}
cd -- "$(dirname -- "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

planes=(item depth barycentric position normal lit)
size=256x256
ways=("cpu exact" "cpu map")
if [ "$kind" = all ]; then
    size=512x512
    ways+=("hybrid exact" "hybrid map" "gpu map")
fi

# hashes SCENE TIME ENGINE SHADOWS : renders, and prints a line for each plane
hashes()
{
    local scene=$1 time=$2 engine=$3 shadows=$4 options=()
    for plane in "${planes[@]}"; do options+=(--aov "$plane=$work/$plane.npy"); done
    [ "$engine $shadows" != "hybrid exact" ] || options+=(--multisample exact)
    [ "$kind" = exact ] || options+=(-o "$work/color.exr" --aa 1)
    "$program" render "$scene" --time "$time" --size "$size" --engine "$engine" --shadows "$shadows" "${options[@]}" \
        >"$work/log" 2>&1 || { echo "picture_hashes.sh: no $engine frame of $scene: $(tail -n 1 "$work/log")" >&2; return 0; }
    for file in "$work"/*.npy "$work"/*.exr; do
        [ -f "$file" ] || continue
        echo "$(sha256sum <"$file" | cut -c1-16) $(basename "$scene") $time $engine $shadows $(basename "${file%.*}")"
    done
    rm -f "$work"/*
}

for way in "${ways[@]}"; do
    read -r engine shadows <<<"$way"
    hashes builtin:torus 0 "$engine" "$shadows"
    for time in 0 2.5 9; do hashes builtin:robots "$time" "$engine" "$shadows"; done
    for time in 0 7.3; do hashes builtin:room "$time" "$engine" "$shadows"; done
    [ "$kind" = all ] || continue
    if [ -f scenes/bunny.stl ]; then hashes scenes/bunny.stl 0 "$engine" "$shadows"; fi
    robot=${FIRSTHIT_TEST_DATA:-}/bart/scene_robot/aff/Robot.aff
    if [ -f "$robot" ]; then for time in 10 30; do hashes "$robot" "$time" "$engine" "$shadows"; done; fi
done
