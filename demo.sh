#!/usr/bin/env bash
# demo.sh - installs what is missing, builds, and renders pictures into out/ with a table of times.
set -euo pipefail
cd -- "$(dirname -- "$0")"

scripts/install_packages.sh build
scripts/fetch_scenes.sh || [ $? -eq 3 ]
scripts/build.sh release -- firsthit_program

firsthit=build/release/bin/firsthit
mkdir -p out/animation
stats=$(mktemp)
trap 'rm -f "$stats"' EXIT

# Mean milliseconds of the frames in $stats, by stage.
print_times()
{
    awk -v name="$1" '
        /"load_ms"/ { load = $2 + 0 }
        /"width"/ { width = $2 + 0 }
        /"height"/ { height = $2 + 0 }
        /"time_s"/ { frames++ }
        /"(pose|setup|raster|resolve|shadow|sky|shade|write|total)_ms"/ { split($1, part, "\""); sum[part[2]] += $2 }
        /"triangles"/ { triangles = $2 + 0 }
        END {
            printf "%-18s %9d %9s %6d %8.1f", name, triangles, width "x" height, frames, load
            split("pose setup raster resolve shadow sky shade write total", stage, " ")
            for (k = 1; k <= 9; k++) printf " %8.2f", sum[stage[k] "_ms"] / frames
            print ""
        }' "$stats"
}

# picture NAME ARGUMENT... : renders, and prints a row of the table.
picture()
{
    local name=$1
    shift
    "$firsthit" render "$@" --stats-json "$stats"
    print_times "$name"
}

echo
echo "milliseconds by stage, mean of the frames; a first frame also pays for its memory"
printf '%-18s %9s %9s %6s %8s' scene triangles size frames load
printf ' %8s' pose setup raster resolve shadow sky shade write total
printf '\n'
picture torus builtin:torus -o out/torus.png
if [ -f scenes/bunny.stl ]; then
    picture bunny scenes/bunny.stl -o out/bunny.png \
        --aov item=out/bunny_item.npy --aov depth=out/bunny_depth.exr
fi
if [ -f scenes/dragon.ply ]; then
    picture dragon scenes/dragon.ply -o out/dragon.png
fi
picture 'robots, exact' builtin:robots --frames 0:10:5 -o out/robots_%d.png
picture 'robots, maps' builtin:robots --frames 0:10:5 -o out/robots_maps_%d.png --shadows map
picture 'robots, a spot' builtin:robots --time 9 -o out/robots_spot.png --light spot:0,7,0,0,-1,0,90,60
picture 'robots, a sun' builtin:robots --time 9 -o out/robots_sun.png --light directional:-1,-0.7,0.4
picture 'room, 7 lights' builtin:room --frames 0:20:3 --size 960x640 -o out/room_%d.png
picture 'room, maps' builtin:room --frames 0:20:3 --size 960x640 -o out/room_maps_%d.png --shadows map
# On OpenGL, where there is one: Mesa's software driver will do.
if "$firsthit" render builtin:torus --size 16x16 --engine gpu -o out/opengl.png 2>out/opengl.txt; then
    picture 'robots, hybrid' builtin:robots --frames 0:10:5 -o out/robots_hybrid_%d.png --engine hybrid
    picture 'robots, gpu' builtin:robots --frames 0:10:5 -o out/robots_gpu_%d.png --engine gpu
else
    echo "without the OpenGL engines: $(cat out/opengl.txt)"
fi
rm -f out/opengl.png out/opengl.txt
picture 'robots, 4x4 rays' builtin:robots --time 5 --samples 4 -o out/robots_smooth.png
picture wave 'builtin:wave?n=100000' --time 1 -o out/wave.png
picture animation builtin:robots --size 640x360 --frames 0:2:48 -o out/animation/robots_%04d.png

echo
echo "the pictures are in out/, the animation in out/animation/"
echo "$firsthit bench --paper measures the engines, in a minute or two"
