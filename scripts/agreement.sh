#!/usr/bin/env bash
# agreement.sh - how far the engines on OpenGL agree with the cpu engine, as tables for docs/agreement.md.
# Usage: agreement.sh PROGRAM [SIZE]. Takes the bunny from scenes/ (scripts/fetch_scenes.sh) or $BUNNY,
# and BART's robots from $FIRSTHIT_TEST_DATA; leaves out what is not there. Needs jq.
set -euo pipefail
program=$(realpath -- "${1:?usage: agreement.sh PROGRAM [SIZE]}")
size=${2:-1024x1024}
cd -- "$(dirname -- "$0")/.."
command -v jq >/dev/null || { echo "agreement.sh: jq is missing" >&2; exit 1; }

names=(torus)
scenes=(builtin:torus)
times=(0)
add() { names+=("$1"); scenes+=("$2"); times+=("$3"); }
bunny=${BUNNY:-scenes/bunny.stl}
robot=${FIRSTHIT_TEST_DATA:-}/bart/scene_robot/aff/Robot.aff
if [ -f "$bunny" ]; then add bunny "$bunny" 0; fi
add '`builtin:robots`, t = 2.5' builtin:robots 2.5
if [ -f "$robot" ]; then add 'BART robots, t = 10' "$robot" 10; fi

# row SCENE_NUMBER LABEL ENGINE OPTION... : a line of a table. Exit code 1 of the program with numbers
# says that they should be 0: they are printed all the same.
row()
{
    local k=$1 label=$2 engine=$3 json
    shift 3
    json=$("$program" compare "${scenes[$k]}" --time "${times[$k]}" --size "$size" --against cpu \
        --engine "$engine" --json "$@") || [ -n "$json" ]
    jq -r --arg scene "${names[$k]}" --arg options "$label" --arg engine "$engine" '
        def decibels: if . == null then "equal" else (. * 10 | round / 10 | tostring) end;
        def share($all): "\(.) (\(. / $all * 1e6 | round / 1e4) %)";
        .pixels as $all
        | "| \($scene) | \($engine) | \($options) | \(.missed | share($all)) | \(.wrong | share($all)) | \(.ties) |"
        + " \(.interpolated) | \(.psnr_db | decibels) | \(.largest_difference * 1e4 | round / 1e4) |"
        + (if has("psnr_same_items_db") then " \(.psnr_same_items_db | decibels) |" else " |" end)
    ' <<<"$json"
}

head_of()
{
    printf '\n| scene | engine | %s | missed | wrong | ties | interpolated | PSNR, dB | largest | PSNR, same items |\n' "$1"
    echo '|---|---|---|---|---|---|---|---|---|---|'
}

head_of multisampling
for k in "${!names[@]}"; do
    for engine in hybrid gpu; do
        for mode in none lazy3 lazy5 full3 full5 exact; do
            row "$k" "$mode" "$engine" --multisample "$mode"
        done
    done
done

head_of formats
for k in "${!names[@]}"; do
    for engine in hybrid gpu; do
        for item in r32ui rgb8 rgba8; do
            row "$k" "$item, float32" "$engine" --multisample none --item-format "$item"
        done
        row "$k" "r32ui, fixed24" "$engine" --multisample none --depth-format fixed24
    done
done
