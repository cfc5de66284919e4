#!/usr/bin/env bash
# view_cli_test.sh - `firsthit view` by scripts without a window: errors, and pictures beside those of render.
# Usage: view_cli_test.sh PROGRAM
source "$(dirname "$0")/cli_checks.sh"
export EGL_PLATFORM=surfaceless

# expect_error CODE TEXT ARGUMENTS...: the program ends with the code and says the text.
expect_error()
{
    local code=$1 text=$2 said got
    shift 2
    checks=$((checks + 1))
    said=$("$program" "$@" 2>&1)
    got=$?
    [ "$got" = "$code" ] || fail "$*: exit code $got, not $code: $said"
    case "$said" in *"$text"*) ;; *) fail "$*: '$said' does not say '$text'" ;; esac
}

printf 'wait rest\njump\n' >bad.txt
printf 'wait rest\nassert engine gpu\n' >untrue.txt
printf 'wait rest\npicture view.png\n' >picture.txt
expect_error 2 "SCENE is required" view
expect_error 2 "bad.txt:2: 'jump' is no action: accepted are key" view builtin:torus --no-window --script bad.txt
expect_error 1 "untrue.txt:2: engine is cpu, not gpu" view builtin:torus --no-window --script untrue.txt --size 64x64
expect_error 1 "no.txt: cannot be read" view builtin:torus --no-window --script no.txt
: >empty.txt
mkdir folder.txt
expect_error 1 "empty.txt: the file is empty" view builtin:torus --no-window --script empty.txt
expect_error 1 "folder.txt: cannot be read" view builtin:torus --no-window --script folder.txt
expect_error 1 "missing.off" view missing.off --no-window --script picture.txt
expect_error 2 "--no-window plays a script" view builtin:torus --no-window
expect_error 2 "--screenshot is of the end of a script" view builtin:torus --screenshot a.png
expect_error 2 "'0' is no number of frames a second from 1 to 1000" view builtin:torus --rate 0
DISPLAY= WAYLAND_DISPLAY= expect_error 1 "firsthit render makes pictures without" view builtin:torus
DISPLAY= WAYLAND_DISPLAY= expect_error 1 "view --serve shows the scene in a page" view builtin:torus

# same_picture OPTIONS...: the picture at rest is that of render, byte for byte.
same_picture()
{
    checks=$((checks + 1))
    rm -f view.png render.png
    "$program" view "$@" --no-window --script picture.txt || fail "view $*"
    "$program" render "$@" -o render.png -q || fail "render $*"
    cmp -s view.png render.png || fail "the pictures of view and render differ: $*"
}

small=(--size 120x90)
for scene in builtin:robots builtin:torus; do
    same_picture "$scene" "${small[@]}"
    same_picture "$scene" "${small[@]}" --shadows none --aa 1
    same_picture "$scene" "${small[@]}" --shadows map --shadow-filter 3
    same_picture "$scene" "${small[@]}" --samples 3 --sky 6
    same_picture "$scene" "${small[@]}" --interleave 2 --exposure 1
    same_picture "$scene" "${small[@]}" --tonemap aces --dither off --view top
    same_picture "$scene" "${small[@]}" --studio on --aa 2
    same_picture "$scene" "${small[@]}" --eye 3,4,9 --at 0,1,0 --fov 50
    same_picture "$scene" "${small[@]}" --background 0.1,0.2,0.4 --light directional:-1,-3,-1
    same_picture "$scene" "${small[@]}" --background transparent
    same_picture "$scene" "${small[@]}" --background 1,1,1:0,0,0.2
    same_picture "$scene" "${small[@]}" --intrinsics 100,100,60,40
done
same_picture builtin:robots "${small[@]}" --time 2.5
same_picture builtin:robots "${small[@]}" --clip none
if "$program" render builtin:torus --size 16x16 --engine gpu -o gpu.png 2>/dev/null; then
    for engine in hybrid gpu; do
        for more in "" "--shadows none" "--item-format rgba8" "--depth-format fixed24" \
            "--multisample full3 --no-interpolate" "--samples 2"; do
            # shellcheck disable=SC2086
            same_picture builtin:robots "${small[@]}" --engine "$engine" $more
        done
    done
    same_picture builtin:robots "${small[@]}" --engine hybrid --readback sync --multisample exact --shadows exact
    same_picture builtin:robots "${small[@]}" --engine gpu --gpu-passes multi
fi

# The camera that a session says is the one of its picture.
printf 'drag 60 45 90 60\nscroll 60 45 2\nwait rest\npicture view.png\nkey c\nscreenshot look.png\n' >moved.txt
checks=$((checks + 1))
"$program" view builtin:torus "${small[@]}" --no-window --script moved.txt --measure >measured.txt ||
    fail "a script that moves the camera"
grep -q "input to screen, [1-9][0-9]* events" measured.txt || fail "--measure: $(cat measured.txt)"
[ -s look.png ] || fail "no screenshot"

echo "$checks checks, $failures failures"
[ "$failures" = 0 ]
