#!/usr/bin/env bash
# picture_cli_test.sh - formats of pictures, transparency, standard input and output. Usage: picture_cli_test.sh
# PROGRAM
# shellcheck source=tests/apps/cli_checks.sh
source "$(dirname "$0")/cli_checks.sh"

png=89504e47
small=(--size 40x30)
accepted=$("$program" render builtin:torus -o a.bmp 2>&1)

# --- formats ------------------------------------------------------------------------------------
writes render builtin:torus "${small[@]}" -o a.png --aov depth=d.png
starts a.png $png
starts d.png $png
case "$accepted" in *.jpg*)
    writes render builtin:torus "${small[@]}" -o a.jpg --quality 90
    starts a.jpg ffd8ff
    refuses 2 'no transparency' render builtin:torus "${small[@]}" -o b.jpg --background transparent ;;
esac
case "$accepted" in *.webp*)
    writes render builtin:torus "${small[@]}" -o a.webp --background transparent
    starts a.webp 52494646
    refuses 1 'WebP holds at most 16383' render builtin:torus --size 16384x1 -o wide.webp ;;
esac
refuses 2 'a.png: --quality is of' render builtin:torus -o a.png --quality 3
refuses 2 'accepted are transparent' render builtin:torus -o b.png --background pink
refuses 2 'say one' render builtin:torus -o b.png --background 0,0,0 --environment 1,1,1 --environment-background on
refuses 2 'say -o FILE too' render builtin:torus --aov item=i.npy --background transparent
writes render builtin:torus "${small[@]}" -o sky.png --background 0.2,0.4,0.9:1,1,1 --samples 2

# --- the same on any number of threads ----------------------------------------------------------
for threads in 1 3; do
    writes render builtin:robots --size 120x90 --samples 2 -o t$threads.png --background transparent --threads $threads
done
cmp -s t1.png t3.png || fail "threads change a picture with transparency"
writes render builtin:robots --size 120x90 -o plain.png --dither off
writes render builtin:robots --size 120x90 -o dithered.png
cmp -s plain.png dithered.png && fail "dithering changes nothing"

# --- far depths are told ------------------------------------------------------------------------
writes render builtin:torus "${small[@]}" --aov depth=far.png --eye 0,0,100 --at 0,0,0 --fov 3
grep -q 'far.png: [0-9]* pixels are farther than 65.535' stderr || fail "no warning of far depths: $(cat stderr)"

# --- standard output ----------------------------------------------------------------------------
"$program" render builtin:torus "${small[@]}" -o - 2>stderr | cmp -s - a.png || fail "-o - is another picture"
"$program" render builtin:torus "${small[@]}" -o - 2>stderr >redirected.png
cmp -s redirected.png a.png || fail "-o - into a file is another picture"
"$program" render builtin:torus "${small[@]}" -o - --output-format exr 2>stderr >out.exr
writes render builtin:torus "${small[@]}" -o a.exr
cmp -s out.exr a.exr || fail "an .exr through a pipe is another: $(cat stderr)"
"$program" render builtin:torus "${small[@]}" --aov depth=- 2>stderr >out.npy
writes render builtin:torus "${small[@]}" --aov depth=a.npy
cmp -s out.npy a.npy || fail "a plane through a pipe is another: $(cat stderr)"
"$program" render builtin:torus "${small[@]}" --turntable 3 -o - 2>stderr >three.png
writes render builtin:torus "${small[@]}" --turntable 3 -o one_%d.png
cat one_0.png one_1.png one_2.png | cmp -s - three.png || fail "frames do not follow each other on standard output"
refuses 2 'taken by a picture' render builtin:torus -o - --stats
refuses 2 'written twice' render builtin:torus -o - --aov item=-
refuses 2 'is of standard output' render builtin:torus -o b.png --output-format exr
actual=0
"$program" render builtin:torus "${small[@]}" -o - >/dev/full 2>stderr || actual=$?
if [ $actual -ne 1 ] || ! grep -q 'standard output: cannot write: No space left' stderr; then
    fail "a full standard output: $actual, $(cat stderr)"
fi

# --- standard input -----------------------------------------------------------------------------
printf '%s\n' 'v -1 -1 0' 'v 1 -1 0' 'v 0 1 0' 'f 1 2 3' >t.obj
export TMPDIR=$PWD/scratch
mkdir scratch
writes render t.obj "${small[@]}" -o t.png
"$program" render - --format obj "${small[@]}" -o - <t.obj 2>stderr >piped.png
cmp -s piped.png t.png || fail "a scene from standard input is another: $(cat stderr)"
"$program" info - --format obj <t.obj >stdout 2>stderr || fail "info of standard input: $(cat stderr)"
refuses 2 'say --format' render - -o b.png
refuses 2 'accepted are gltf, glb' render - --format jpg -o b.png
refuses 2 "'t.obj' has its ending" render t.obj --format obj -o b.png
refuses 1 'standard input: it is empty' render - --format ply -o b.png
for kind in ply stl obj off glb gltf aff nff 3mf dae fbx; do
    actual=0
    head -c 3000 /dev/urandom | timeout 60 "$program" render - --format $kind "${small[@]}" -o b.png >stdout 2>stderr || actual=$?
    checks=$((checks + 1))
    [ $actual -eq 1 ] || fail "noise as $kind: exit code $actual: $(cat stderr)"
    grep -q 'standard input' stderr || fail "noise as $kind: the message does not say from where: $(cat stderr)"
    grep -q "$PWD" stderr && fail "noise as $kind: the message names a temporary file: $(cat stderr)"
done
[ -z "$(ls -A scratch)" ] || fail "standard input leaves $(ls -A scratch)"

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
