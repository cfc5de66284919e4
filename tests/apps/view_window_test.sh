#!/usr/bin/env bash
# view_window_test.sh - the window of `firsthit view` under Xvfb: every switch, way of looking, key and panel is seen to
# change what it should. Ends with 77, which ctest counts as skipped, where Xvfb or the window is missing.
# Usage: view_window_test.sh PROGRAM
source "$(dirname "$0")/cli_checks.sh"
source "$scripts/hidden_screen.sh"

size=640x480
# play SCENE SCRIPT OPTIONS...: plays a script in a window.
play()
{
    local scene=$1
    printf '%s\n' "$2" >script.txt
    shift 2
    timeout 300 "$program" view "$scene" --size $size --script script.txt "$@" 2>said.txt
}

# changes WHAT ACTIONS: the window after the actions is another than before. Panels that count are hidden.
changes()
{
    local what=$1 actions=$2 first=${3:-choose bars off
choose corner off
choose hover off}
    checks=$((checks + 1))
    rm -f before.png after.png
    play "${scene:-builtin:robots}" "$first
wait rest
screenshot before.png
$actions
screenshot after.png" || { fail "$what: $(cat said.txt)"; return; }
    [ -s before.png ] && [ -s after.png ] || { fail "$what: no screenshot"; return; }
    cmp -s before.png after.png && fail "$what: nothing changes on the screen"
}

# Ways of looking.
for look in items instances materials depth normals light light-view difference; do
    changes "look $look" "choose look $look
wait rest"
done
# Switches that change the picture.
quiet="choose panel off
choose bars off
choose corner off
choose hover off"
for pair in "shadows none" "shadows map" "samples 3" "aa 1" "interleave 4" "sky 12" "studio on" "exposure 1" \
    "tonemap aces" "dither off" "time 3" "selected 3"; do
    changes "$pair" "choose $pair
wait rest" "$quiet"
done
changes "clip -1" "choose clip -1
wait rest" "$quiet
choose time 3"
for pair in "shadow-filter 9" "shadow-map-size 32" "shadow-bias 1"; do
    changes "$pair" "choose $pair
wait rest" "$quiet
choose shadows map"
done
# Switches whose picture is the same are seen in the panel.
size=640x1000
for pair in "engine hybrid" "engine gpu" "loop off" "speed 2" "rate 30" "hold off" "tile-size 16" "interpolate off" \
    "play on" "turntable on"; do
    changes "$pair in the panel" "choose $pair
wait 5 frames"
done
size=640x480
# Keys.
for key in 1 3 7 0 shift+1 shift+3 shift+7 left right up down + - . h v; do
    changes "key $key" "key $key
wait rest" "$quiet"
done
for key in w a s d q e; do
    changes "key $key" "key $key 0.3
wait rest" "$quiet"
done
for key in tab b f1 '?' c; do changes "key $key" "key $key
wait 3 frames"; done
changes "key i" "mouse 500 300
wait pick
wait 3 frames" "choose bars off
choose corner off"
changes "drag" "drag 400 200 460 240
wait rest" "$quiet"
changes "drag with shift" "drag 400 200 460 240 shift
wait rest" "$quiet"
changes "drag with the middle button" "drag 400 200 460 240 middle
wait rest" "$quiet"
changes "drag with the right button" "drag 400 200 460 240 right
wait rest" "$quiet"
changes "wheel" "scroll 400 200 3
wait rest" "$quiet"
changes "click selects" "mouse 320 300
wait pick
click 320 300
wait rest
refute selected -1" "choose panel off
choose bars off
choose corner off"

# The hand takes panels, not the picture below them: the first header of the panel closes.
changes "click on the panel" "click 100 60
wait 5 frames
assert selected -1"

# The same after a drag on the picture.
changes "click on the panel after a drag" "click 100 64
wait 5 frames" "choose bars off
choose corner off
choose hover off
drag 400 200 430 210"

# What is on the screen, without panels, is the picture of render.
checks=$((checks + 1))
play builtin:robots "$quiet
wait rest
screenshot window.png
picture picture.png" || fail "the picture: $(cat said.txt)"
"$program" render builtin:robots --size 640x480 -o render.png -q
cmp -s picture.png render.png || fail "the picture of the window is not that of render"
python3 "$scripts/serve/png_pixels.py" window.png render.png || fail "the pixels of the window are not those of render"

# Size, files.
checks=$((checks + 1))
play builtin:torus "wait rest
resize 500 300
wait rest
picture small.png
open nothing.off
wait rest
open builtin:robots
wait rest
key f12
screenshot end.png" --screenshot last.png || fail "size and files: $(cat said.txt)"
[ -s firsthit-001.png ] && [ -s last.png ] || fail "F12 or --screenshot wrote nothing"

echo "$checks checks, $failures failures"
[ "$failures" = 0 ]
