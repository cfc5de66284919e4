#!/usr/bin/env bash
# cli_test.sh - the program as a user meets it: exit codes, messages, files. Usage: cli_test.sh PROGRAM
# shellcheck source=tests/apps/cli_checks.sh
source "$(dirname "$0")/cli_checks.sh"

# expect_files NAME... : exactly these beside the test's own.
expect_files()
{
    local found expected=""
    [ $# -eq 0 ] || expected=$(printf "%s\n" "$@" | sort | tr "\n" " ")
    found=$(find . -mindepth 1 ! -name stdout ! -name stderr ! -path './input*' -printf '%P\n' | sort | tr '\n' ' ')
    checks=$((checks + 1))
    [ "$found" = "$expected" ] || fail "files: '$found', not '$*'"
    find . -mindepth 1 ! -name stdout ! -name stderr ! -path './input*' -delete
}

mkdir -p input/folder.png

# --- what it does -----------------------------------------------------------------------------
expect 0 'render.*Make pictures' --help
expect 0 'Usage: firsthit render' render --help
expect 0 'Usage: firsthit info' info --help
expect 0 'ours_wrong' compare --help-all
expect 0 'bitorder' occlusion --help-all
expect 0 '^[^ ]*firsthit [0-9]+\.[0-9]+\.[0-9]+$' --version

expect 0 '' render builtin:torus -o a.png --size 33x17
[ ! -s stderr ] || fail "a render that goes well prints on stderr: $(head -c 300 stderr)"
starts a.png 89504e470d0a1a0a0000000d494844520000002100000011
expect_files a.png
expect 0 '' render builtin:torus -o a.exr --size 8x8
starts a.exr 762f3101
expect_files a.exr
expect 0 '' render builtin:torus --size 8x4 --aov item=i.npy --aov depth=d.npy --aov uv=uv.exr \
    --aov normal=n.npy --aov geometric_normal=g.exr --aov position=p.npy --aov albedo=al.exr \
    --aov distance=t.exr --aov item=i.exr --aov barycentric=b.npy
starts i.npy 934e554d5059
grep -qa "'<u4'.*(4, 8)" i.npy || fail "i.npy has another type or shape"
grep -qa "'<f4'.*(4, 8, 3)" n.npy || fail "n.npy has another type or shape"
expect_files i.npy d.npy uv.exr n.npy g.exr p.npy al.exr t.exr i.exr b.npy
expect 0 '' render builtin:robots --size 8x8 --frames 0:2:3 -o f_%03d.png --aov item=f_%03d.npy
expect_files f_000.png f_001.png f_002.png f_000.npy f_001.npy f_002.npy
expect 0 'tile entries' render builtin:torus --size 16x16 --stats
expect 0 '"interpolated": 128' render builtin:torus --size 16x16 --interleave 2 --stats-json -
expect 0 '"interpolated": 0' render builtin:torus --size 16x16 --interleave 2 --no-interpolate --stats-json -
expect 0 '"exact_calls"' render builtin:torus --size 16x16 --stats-json -
expect 0 '' render builtin:torus --size 16x16 --stats-json s.json
grep -q '"raster_ms"' s.json || fail "s.json has no raster_ms"
expect_files s.json
expect 0 '' render builtin:torus -o a.png --size 16x16 --eye -.5,3,4 --at 0,0,0 --up 0,1,0 --fov 30
expect 0 '' render builtin:torus -o b.png --size 16x16 --eye 0,5,0 --threads 2 --samples 3 --time 1
expect_files a.png b.png
expect 0 '' render builtin:torus -o a.png --aov lit=l.npy --aov lit=l.exr --size 8x4 --shadows none \
    --light point:1,5,2 --light spot:0,4,0,0,-1,0,40,30 --light directional:-1,-2,-1
grep -qa "'<f4'.*(4, 8, 3)" l.npy || fail "l.npy has another type or shape"
grep -qa 'lit\.2' l.exr || fail "l.exr has no channel lit.2"
expect_files a.png l.npy l.exr
expect 0 '' render builtin:torus -o /dev/null --size 16x16
[ -c /dev/null ] || fail "/dev/null is no device any more"

# The same picture for any number of threads and size of tiles.
expect 0 '' render builtin:robots -o a.png --size 100x75 --time 3 --threads 1
expect 0 '' render builtin:robots -o b.png --size 100x75 --time 3 --threads 3 --tile-size 8
cmp -s a.png b.png || fail "the picture depends on threads or tiles"
expect_files a.png b.png

expect 0 '^.*triangles +1024$' info builtin:torus
expect 0 '"triangles": 1024' info builtin:torus --json
expect 0 'bounds' info builtin:robots
expect 0 'lights +7: 6 point, 1 directional' info builtin:room
expect 0 'ours wrong +0$' compare builtin:torus --against brute --size 32x32
expect 0 '"ours_wrong": 0' compare builtin:torus --against brute --size 40x30 --json
grep -q '"pixels": 1200,' stdout || fail "compare counts other pixels than 40x30"
expect 0 '"pixels": 512' compare builtin:torus --against brute --size 16x16 --frames 0:1:2 --json
[ ! -s stderr ] || fail "a progress bar in a pipe"

expect 0 '"lit_ours_wrong": 0' compare builtin:robots --against brute --size 32x32 --shadows exact --json
expect 0 '"lit_ours_wrong": 0' compare builtin:room --against brute --size 24x16 --time 7 --shadows exact --json
# Where there is an OpenGL.
if "$program" compare builtin:torus --against cpu --engine gpu --size 16x16 >stdout 2>stderr; then
    expect 0 'PSNR, same items' compare builtin:torus --against cpu --engine gpu --size 32x32
    expect 0 '"missed": 0' compare builtin:torus --against cpu --engine hybrid --multisample exact \
        --size 40x30 --frames 0:1:2 --json
    grep -q '"pixels": 2400,' stdout || fail "compare --against cpu counts other pixels than 2 x 40x30"
    expect 0 '"interpolated": 0' compare builtin:torus --against cpu --engine gpu --size 40x30 \
        --multisample none --no-interpolate --item-format rgba8 --depth-format fixed24 --json
else
    echo "skipped: comparing engines: $(head -n 1 stderr)"
    grep -q OpenGL stderr || fail "compare --against cpu fails without a word about OpenGL: $(cat stderr)"
fi

expect 0 'lit theirs wrong +[0-9]+$' compare builtin:torus --against embree --size 32x32 --shadows exact

# Points: the middle of the torus's hole, inside of its tube, above it, and no number.
o=00000000 one=0000803f two=00000040
npy input/points.npy '<f4' '(4, 3)' "$o$o$o$one$o$o$o$two$o${o}0000c07f$o"
npy input/directions.npy '<f4' '(2, 3)' "$o${one}$o${o}0000803f$o"
npy input/ids.npy '<i4' '(4,)' 00000000ffffffffffffffffffffffff
expect 0 '' occlusion builtin:torus --points input/points.npy --direction 0,-1,0 -o a.npy
grep -qa "'|u1'.*(4,)" a.npy || fail "occlusion of one direction has another type or shape"
[ "$(tail -c 4 a.npy | od -An -tx1 | tr -d ' \n')" = 00010000 ] || fail "occlusion has other answers"
expect 0 '"occluded": 2' occlusion builtin:torus --points input/points.npy --direction 0,-1,0 \
    --direction 1,-9,0 --json -o b.npy
grep -qa "'|u1'.*(2, 4)" b.npy || fail "occlusion of two directions has another shape"
expect 0 'test +[0-9.]+ ms' occlusion builtin:torus --points input/points.npy --stats --packed \
    --directions input/directions.npy --receivers input/ids.npy --time 1 --threads 2 -o c.npy
grep -qa "'|u1'.*(2, 1)" c.npy || fail "packed occlusion has another shape"
[ "$(tail -c 2 c.npy | od -An -tx1 | tr -d ' \n')" = 0202 ] || fail "packed occlusion has other answers"
expect 0 '' occlusion builtin:torus --points input/points.npy --light 0,5,0 --light spot:0,5,0,0,1,0,40 -o d.npy
expect_files a.npy b.npy c.npy d.npy
expect 2 '--points' occlusion builtin:torus --direction 0,1,0 -o a.npy
expect 2 '--output' occlusion builtin:torus --points input/points.npy --direction 0,1,0
expect 2 'no light' occlusion builtin:torus --points input/points.npy -o a.npy
expect 2 'accepted are .npy and .csv' occlusion builtin:torus --points input/points.npy --direction 0,1,0 -o a.exr
expect 2 'excludes' occlusion builtin:torus --points input/points.npy --direction 0,1,0 --light 0,1,0 -o a.npy
expect 2 'excludes' occlusion builtin:torus --points input/points.npy --direction 0,1,0 \
    --directions input/directions.npy -o a.npy
for value in 0,0,0 1,2 a,b,c nan,0,0 ''; do
    expect 2 '--direction: ' occlusion builtin:torus --points input/points.npy --direction "$value" -o a.npy
done
expect 2 '--light: ' occlusion builtin:torus --points input/points.npy --light spot:1 -o a.npy
expect 1 'input/none.npy: no such file' occlusion builtin:torus --points input/none.npy --direction 0,1,0 -o a.npy
expect 1 'only \(N, 3\)|only float32' occlusion builtin:torus --points input/ids.npy --direction 0,1,0 -o a.npy
expect 1 'only bool, and integers' occlusion builtin:torus --points input/points.npy --receivers input/points.npy \
    --direction 0,1,0 -o a.npy
npy input/zero.npy '<f4' '(1, 3)' "$o$o$o"
expect 1 'zero.npy: row 0: .* is no direction' occlusion builtin:torus --points input/points.npy \
    --directions input/zero.npy -o a.npy
npy input/few.npy '<u4' '(1,)' 00000000
expect 1 '1 receivers for the 4 points' occlusion builtin:torus --points input/points.npy \
    --receivers input/few.npy --direction 0,1,0 -o a.npy
expect 1 "folder 'none' does not exist" occlusion builtin:torus --points input/points.npy --direction 0,1,0 -o none/a.npy
expect_files

# --- wrong usage ------------------------------------------------------------------------------
expect 2 'subcommand' 
expect 2 'Run firsthit --help' nonsense
expect 2 'SCENE' render
expect 2 'nothing is asked for' render builtin:torus
expect 2 'Run firsthit render --help' render builtin:torus -o a.png --nonsense
expect 2 '' render builtin:torus extra -o a.png
for size in 0x0 0x5 5x0 -1x5 100000x100000 65537x1 12xx x 12 '' 1x2x3 1.5x2 ax2 99999999999999999999x1; do
    expect 2 '--size.*accepted is WIDTHxHEIGHT' render builtin:torus -o a.png --size "$size"
    expect 2 '--size' compare builtin:torus --against brute --size "$size"
done
for value in 0 17 -1 two 1.5; do
    expect 2 '--samples' render builtin:torus -o a.png --samples "$value"
done
for value in 0 3 17 32 -1 two 1.5 02; do
    expect 2 '--interleave.*accepted: 1, 2, 4, 8 or 16' render builtin:torus -o a.png --interleave "$value"
done
expect 2 'none, lazy3, lazy5, full3, full5 or exact' render builtin:torus -o a.png --multisample lazy7
expect 2 '--interleave' render builtin:torus -o a.png --interleave 2 --samples 2
for value in 0 17 x -1; do
    expect 2 '--aa' render builtin:torus -o a.png --aa "$value"
done
expect 2 'say one' render builtin:torus -o a.png --aa 3 --samples 2
expect 2 'say one' render builtin:torus -o a.png --aa 3 --interleave 2
expect 2 'has no --aa' render builtin:torus -o a.png --aa 3 --engine gpu --shadows map
expect 0 'fine pixels  ' render builtin:torus --size 16x16 --aa 3 --stats
for value in -1 1025 many; do
    expect 2 '--threads' render builtin:torus -o a.png --threads "$value"
done
for value in 0 180 -10 nan wide; do
    expect 2 '--fov' render builtin:torus -o a.png --fov "$value"
done
for value in 1,2 1,2,3,4 a,b,c nan,0,0 '' 1,,2; do
    expect 2 '--eye' render builtin:torus -o a.png --eye "$value"
done
for value in lamp:1,2,3 point:1,2 spot:0,4,0,0,-1,0 spot:0,4,0,0,-1,0,180 directional:0,0,0 ''; do
    expect 2 '--light.*accepted|--light.*no (finite|angle)' render builtin:torus -o a.png --light "$value"
done
for value in -1 257 1.5 many 16,1 16,1,2,x 16,-1,0,0; do
    expect 2 '--sky' render builtin:torus -o a.png --sky "$value"
done
expect 2 'neither on nor off' render builtin:torus -o a.png --studio bright
expect 2 'say one' render builtin:torus -o a.png --studio on --light point:0,4,0
expect 2 'say one' render builtin:torus -o a.png --draft --sky 8
expect 2 'accepted are none, map and exact' render builtin:torus -o a.png --shadows soft
for value in 8 8193 big; do
    expect 2 'no integer from 16 to 8192' render builtin:torus -o a.png --shadow-map-size "$value"
done
expect 2 'say --shadows map' render builtin:torus -o a.png --shadow-bias 0.1
expect 2 'coincide' render builtin:torus -o a.png --eye 1,1,1 --at 1,1,1
expect 2 'parallel' render builtin:torus -o a.png --eye 0,0,5 --at 0,0,0 --up 0,0,1
expect 2 '--time' render builtin:torus -o a.png --time inf
expect 2 'excludes' render builtin:torus -o %d.png --time 1 --frames 0:1:2
for value in 0:1 0:1:0 0:1:-5 0:1:2:3 a:b:c 0:1:4000000000 nan:1:2; do
    expect 2 '--frames' render builtin:torus -o %d.png --frames "$value"
done
for name in a.png %s.png %n.png %d%d.png %999999999d.png '%1$d.png' %.png; do
    expect 2 'exactly one place' render builtin:torus --frames 0:1:2 -o "$name"
done
expect 2 'say which with --frames' render builtin:torus -o a_%04d.png
expect 2 'accepted are .png, ' render builtin:torus -o a.bmp
expect 2 'accepted are .png, ' render builtin:torus -o a
expect 2 'accepted are .exr and .npy' render builtin:torus --aov uv=a.png
expect 2 'accepted are item, depth' render builtin:torus --aov colour=a.exr
expect 2 'NAME=FILE' render builtin:torus --aov depth
expect 2 'written twice' render builtin:torus -o a.exr --aov depth=a.exr
expect 2 '--against' compare builtin:torus
expect 2 'accepted are none and exact' compare builtin:torus --against brute --shadows map
expect 2 'accepted are brute, embree and cpu' compare builtin:torus --against guessing
expect 2 'needs an engine on OpenGL' compare builtin:torus --against cpu
expect 2 'with --against cpu' compare builtin:torus --against brute --engine gpu
expect_files

# --- what fails -------------------------------------------------------------------------------
expect 1 'input/missing.ply' render input/missing.ply -o a.png
expect 1 'input/missing.ply' info input/missing.ply
expect 1 'input/missing.ply' compare input/missing.ply --against brute
for ending in aff nff ply stl obj off fbx dae 3mf; do
    : >"input/empty.$ending"
    head -c 4096 /dev/urandom >"input/garbage.$ending"
    expect 1 "input/empty.$ending" render "input/empty.$ending" -o a.png
    expect 1 "input/garbage.$ending" render "input/garbage.$ending" -o a.png
done
expect 1 '' render input -o a.png
expect 1 '' render input/scene.unknown -o a.png
expect 1 '' render '' -o a.png
expect 1 'builtin:' render builtin:nonsense -o a.png
expect 1 '' render 'builtin:wave?n=0' -o a.png
expect 1 '' render 'builtin:wave?n=4000000000' -o a.png
expect 1 "folder 'none' does not exist" render builtin:torus -o none/a.png
expect 1 "folder 'none' does not exist" render builtin:torus --aov item=none/a.npy
expect 1 "folder 'none' does not exist" render builtin:torus --stats-json none/a.json
expect 1 'Is a directory' render builtin:torus -o input/folder.png
expect_files

# A full disk, by device and by a link that has an ending.
for name in png exr npy json; do ln -s /dev/full "input/full.$name"; done
expect 1 '/dev/full: cannot write: No space left' render builtin:torus --size 16x16 -o /dev/full
expect 1 'full.exr: cannot write: No space left' render builtin:torus --size 16x16 -o input/full.exr
expect 1 'full.exr: cannot write: No space left' render builtin:torus --size 16x16 --aov uv=input/full.exr
expect 1 'full.npy: cannot write: No space left' render builtin:torus --size 16x16 --aov uv=input/full.npy
expect 1 'full.json: cannot write: No space left' render builtin:torus --size 16x16 --stats-json input/full.json
for command in 'info builtin:torus' 'render builtin:torus --size 8x8 --stats' '--version' '--help'; do
    # shellcheck disable=SC2086 # words
    "$program" $command >/dev/full 2>stderr
    [ $? -eq 1 ] || fail "firsthit $command >/dev/full does not fail"
    grep -q 'standard output: cannot write: No space left' stderr || fail "$command >/dev/full: $(cat stderr)"
done
expect_files

# A film that no machine has the memory for is refused before anything is allocated.
if [ "$(awk '/MemTotal/ { print int($2 / 1000000) }' /proc/meminfo)" -lt 200 ]; then
    expect 1 'GB of memory' render builtin:torus -o a.png --size 65536x65536 --aov normal=n.exr \
        --aov position=p.exr --aov albedo=q.exr --aov geometric_normal=g.exr
    expect_files
fi

# --- engines ----------------------------------------------------------------------------------
expect 2 "'cuda' is no engine: accepted are cpu, hybrid, gpu and auto" render builtin:torus -o a.png --engine cuda
expect 2 'accepted are r32ui, rgb8 and rgba8' render builtin:torus -o a.png --item-format rgb
expect 2 'accepted are float32 and fixed24' render builtin:torus -o a.png --depth-format 16
expect 2 'accepted are sync and async' render builtin:torus -o a.png --readback later
expect 2 'accepted are single and multi' render builtin:torus -o a.png --gpu-passes two
expect 2 '--readback-chunks' render builtin:torus -o a.png --readback-chunks 65
expect 2 'has shadow maps only' render builtin:torus -o a.png --engine gpu --shadows exact
expect_files
# Nothing to draw on, and too old a version: a clear refusal, and the cpu engine where the choice is ours.
without_opengl()
{
    export "$1"
    expect 1 'OpenGL' render builtin:torus --size 16x16 -o a.png --engine gpu
    expect 1 'OpenGL' render builtin:torus --size 16x16 -o a.png --engine hybrid
    expect_files
    expect 0 'firsthit: engine cpu: ' render builtin:torus --size 16x16 -o a.png --engine auto
    expect_files a.png
    unset "${1%%=*}"
}
without_opengl __EGL_VENDOR_LIBRARY_DIRS=/nonexistent
without_opengl MESA_GL_VERSION_OVERRIDE=3.3
if "$program" render builtin:torus --size 16x16 -o a.png --engine gpu 2>stderr; then
    for engine in hybrid gpu; do
        expect 0 "\"engine\": \"$engine\"" render builtin:torus --size 16x16 -o a.png --engine $engine --stats-json -
        expect 0 "engine $engine on .*OpenGL 4" render builtin:torus --size 16x16 -o a.png --engine $engine --stats
    done
    expect 0 '' render builtin:torus --size 16x16 --engine hybrid --aov item=h.npy --multisample exact
    expect 0 '' render builtin:torus --size 16x16 --engine gpu --aov item=g.npy --multisample exact
    expect 0 '' render builtin:torus --size 16x16 --aov item=c.npy
    cmp -s h.npy c.npy || fail "items of the hybrid engine are not those of the cpu engine"
    cmp -s g.npy c.npy || fail "items of the gpu engine are not those of the cpu engine"
    expect_files a.png h.npy g.npy c.npy
else
    echo "skipped: 7 checks of the OpenGL engines, which are not here: $(cat stderr)"
fi

# Stopped in the middle of an animation, what is there is whole and nothing else is.
"$program" render builtin:robots --frames 0:10:100000 -o f_%06d.png --size 64x64 >stdout 2>stderr &
child=$!
for _ in $(seq 600); do
    [ -e f_000001.png ] && break
    sleep 0.1
done
kill -INT "$child" 2>/dev/null || kill -TERM "$child"
# A shell that runs in the background ignores SIGINT for its children.
sleep 0.2
kill -TERM "$child" 2>/dev/null
wait "$child" 2>/dev/null && fail "an interrupted animation exits with 0"
find . -name '.firsthit-*' | grep -q . && fail "an interrupted animation leaves a temporary file"
for file in f_*.png; do
    [ "$(tail -c 8 "$file" | od -An -tx1 | tr -d ' \n')" = 49454e44ae426082 ] || fail "$file is not whole"
done

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
