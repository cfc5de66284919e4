#!/usr/bin/env bash
# output_cli_test.sh - what becomes of files that are there: inputs stay, links and permissions too, and a write
# that fails or is stopped leaves nothing. Usage: output_cli_test.sh PROGRAM
# shellcheck source=tests/apps/cli_checks.sh
source "$(dirname "$0")/cli_checks.sh"

# --- inputs stay --------------------------------------------------------------------------------
# Files of the scenes have the endings of outputs, so that no ending is what is refused.
writes render builtin:torus --size 4x4 -o tex.png
for copy in tex_0002.png far.png; do cp tex.png "$copy"; done
printf 'newmtl m\nmap_Kd tex.png\nnewmtl n\nmap_Kd tex_0002.png\n' >t.exr
printf '%s\n' 'mtllib t.exr' 'v -1 -1 0' 'v 1 -1 0' 'v 0 1 0' 'vt 0 0' 'vt 1 0' 'vt 0 1' 'usemtl m' 'f 1/1 2/2 3/3' \
    'usemtl n' 'f 1/1 3/3 2/2' >t.obj
mkdir aff TextureFiles
mv far.png TextureFiles
echo 'i 0 part.exr' >aff/main.aff
echo 'tt far.png 0 0 0 0 0 1 0 0 1 0 0 1 0 0 1' >aff/part.exr
ln -s tex.png symbolic.png
ln tex.png hard.png
ln -s . sub
cd aff && ln -s ../TextureFiles/far.png far_link.png && cd ..

small=(--size 8x8)
refuses 1 "tex.png: cannot write: it would replace the input '(./)?tex.png'" render t.obj "${small[@]}" -o tex.png
refuses 1 "symbolic.png: .* the input '(./)?tex.png'" render t.obj "${small[@]}" -o symbolic.png
refuses 1 "hard.png: .* the input '(./)?tex.png'" render t.obj "${small[@]}" -o hard.png
refuses 1 "sub/./tex.png: .* the input '(./)?tex.png'" render t.obj "${small[@]}" -o sub/./tex.png
refuses 1 "$PWD/tex.png: .* the input '(./)?tex.png'" render t.obj "${small[@]}" -o "$PWD/tex.png"
refuses 1 "t.exr: .* the input '(./)?t.exr'" render t.obj "${small[@]}" -o t.exr
refuses 1 "t.exr: .* the input '(./)?t.exr'" render t.obj "${small[@]}" -o fresh.png --aov depth=t.exr
refuses 1 "t.obj: .* the input 't.obj'" render t.obj "${small[@]}" -o fresh.png --stats-json t.obj
refuses 1 "t.exr: .* the input '(./)?t.exr'" render t.obj "${small[@]}" --stats-json t.exr
refuses 1 "tex_0002.png: .* the input '(./)?tex_0002.png'" render t.obj "${small[@]}" --frames 0:1:4 -o tex_%04d.png
refuses 1 "aff/part.exr: .* the input 'aff/part.exr'" render aff/main.aff "${small[@]}" -o aff/part.exr
refuses 1 "far.png: .* the input 'aff/[.][.]/TextureFiles/far.png'" \
    render aff/main.aff "${small[@]}" -o TextureFiles/far.png
refuses 1 "aff/far_link.png: .* the input" render aff/main.aff "${small[@]}" -o aff/far_link.png
writes render t.obj "${small[@]}" --frames 0:1:2 -o tex_%04d.png
rm tex_0000.png tex_0001.png

zero=000000000000000000000000
npy points.npy '<f4' '(1, 3)' $zero
npy directions.npy '<f4' '(1, 3)' 0000803f0000000000000000
ln points.npy points_too.npy
npy receivers.npy '<i4' '(1,)' ffffffff
cp t.obj by_library.obj
cp t.exr library.npy
sed -i 's/t\.exr/library.npy/' by_library.obj
occlusion=(--points points.npy --directions directions.npy --receivers receivers.npy)
writes occlusion by_library.obj "${occlusion[@]}" -o answers.npy
for input in points directions receivers library; do
    refuses 1 "$input.npy: .* the input '(./)?$input.npy'" occlusion by_library.obj "${occlusion[@]}" -o $input.npy
done
refuses 1 "points_too.npy: .* the input 'points.npy'" occlusion by_library.obj "${occlusion[@]}" -o points_too.npy

refuses 1 "aff/main.aff: .* the input 'aff/main.aff'" bench --paper --quick --bart aff/main.aff --json aff/main.aff
refuses 1 "aff/part.exr: .* the input 'aff/part.exr'" bench --baseline --quick --bart aff/main.aff --json aff/part.exr
mkdir report
ln aff/main.aff report/bench.json
refuses 1 "report/bench.json: .* the input 'aff/main.aff'" bench --paper --quick --bart aff/main.aff -o report

# --- links and permissions ----------------------------------------------------------------------
ln -s real.png link.png
writes render builtin:torus "${small[@]}" -o link.png
if [ ! -L link.png ] || [ ! -f real.png ] || [ -L real.png ]; then fail "a link to nothing yet is not followed"; fi
chmod 600 real.png
writes render builtin:torus "${small[@]}" -o link.png
if [ ! -L link.png ] || [ "$(stat -c %a real.png)" != 600 ]; then fail "a file's permissions are not kept"; fi
refuses 1 "'none' does not exist" render builtin:torus "${small[@]}" -o none/a.png
ln -s none/a.png astray.png
refuses 1 "astray.png: .*folder 'none' does not exist" render builtin:torus "${small[@]}" -o astray.png
ln -s circle.png circle.png
refuses 1 'Too many levels of symbolic links' render builtin:torus "${small[@]}" -o circle.png
"$program" render builtin:torus "${small[@]}" -o /dev/stdout 2>stderr | cmp -s - real.png || \
    fail "a picture to a pipe is another: $(cat stderr)"
mkfifo pipe.png
cat pipe.png >from_pipe.png & reader=$!
writes render builtin:torus "${small[@]}" -o pipe.png
wait $reader
if ! cmp -s from_pipe.png real.png || [ ! -p pipe.png ]; then fail "a pipe is not written as a pipe"; fi

# --- a limit on the size of files -----------------------------------------------------------------
# 8 KB: what the program prints fits, a picture of noise does not.
too_large()
{
    local file=$1 pattern=$2 actual=0
    shift 2
    rm -f "$file"
    (ulimit -f 8; "$program" "$@" >stdout 2>stderr </dev/null) || actual=$?
    checks=$((checks + 1))
    [ $actual -eq 1 ] || fail "firsthit $* beyond the limit: exit code $actual"
    grep -q "$pattern" stderr || fail "firsthit $* beyond the limit: $(cat stderr)"
    [ ! -e "$file" ] || fail "firsthit $* beyond the limit leaves $file"
    find . -name '.firsthit-*' | grep -q . && fail "firsthit $* beyond the limit leaves a temporary file"
}
for name in a.png a.exr; do
    too_large $name "$name: cannot write: File too large" render builtin:robots --size 200x200 -o $name
done
too_large a.npy 'a.npy: cannot write: File too large' render builtin:torus --size 200x200 --aov item=a.npy
printf %s old >a.npy
(ulimit -f 8; "$program" render builtin:torus --size 200x200 --aov item=a.npy 2>stderr) && fail "no limit on sizes"
[ "$(cat a.npy)" = old ] || fail "a write beyond the limit spoils the old file"

# --- signals -------------------------------------------------------------------------------------
# Of several frames, whatever file is there is whole; a signal that is ignored ends nothing.
many=(render builtin:robots --size 160x90 --aa 1 --frames 0:4:60)
for disposition in - ''; do
    rm -f signal_*.png
    (trap "$disposition" TERM; exec "$program" "${many[@]}" -o signal_%d.png) >stdout 2>stderr </dev/null &
    pid=$!
    while [ ! -e signal_2.png ] && kill -0 $pid 2>>stderr; do sleep 0.01; done
    kill -TERM $pid
    code=0
    wait $pid || code=$?
    checks=$((checks + 1))
    count=$(find . -name 'signal_*.png' | wc -l)
    if [ -z "$disposition" ]; then
        [ "$code" -eq 0 ] && [ "$count" -eq 60 ] || fail "an ignored signal: exit code $code, $count files: $(head -c 200 stderr)"
    else
        [ "$code" -eq 143 ] || fail "a signal: exit code $code"
    fi
    for file in signal_*.png; do
        [ "$(tail -c 8 "$file" | head -c 4)" = IEND ] || fail "$file is cut off"
    done
done
[ -z "$(find . -name '.*' -type f)" ] || fail "files under temporary names: $(ls -a)"

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
