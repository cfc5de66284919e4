#!/usr/bin/env bash
# sequence_cli_test.sh - numbered files as a user meets them. Usage: sequence_cli_test.sh PROGRAM
# shellcheck source=tests/apps/cli_checks.sh
source "$(dirname "$0")/cli_checks.sh"

# triangle FILE X : one triangle that moves along x.
triangle()
{
    printf 'v %s 0 0\nv %s 0 0\nv %s 1 0\nf 1 2 3\n' "$2" "$(($2 + 1))" "$2" >"$1"
}

mkdir frames
for number in 1 2 3 4 5 6 7 8; do triangle "frames/000$number.obj" "$number"; done

# --- one animation ------------------------------------------------------------------------------
expect 0 'sequence +8 frames, 24 a second, 0 s to 0.291667 s' info frames/%04d.obj
expect 0 'one topology: frames are interpolated' info frames/%04d.obj
expect 0 'sequence +8 frames, 4 a second, 0 s to 1.75 s' info frames/%04d.obj --fps 4
expect 0 '"end_s": 7.0' info frames/%04d.obj --fps 1 --json
expect 0 'ours wrong +0$' compare frames/%04d.obj --fps 1 --frames 0.35:6.9:10 --against brute --size 32x32
expect 0 '' render frames/%04d.obj --fps 1 --time 6.5 -o late.png --size 16x16 --eye 0,0,9 --at 0,0,0
expect 0 '' render frames/%04d.obj --frames 0:1:3 -o out_%d.png --size 16x16
[ -s out_0.png ] && [ -s out_2.png ] || fail "render of a sequence: no pictures"
header="{'descr': '<f4', 'fortran_order': False, 'shape': (1, 3), }"
{ printf '\x93NUMPY\x01\x00%b' "\\x$(printf %02x $((${#header} + 1)))\\x00"
  printf '%s\n\0\0\0\0\0\0\0\0\0\0\x80\x3f' "$header"; } >points.npy # (0, 0, 1)
expect 0 '"occluded": 0' occlusion frames/%04d.obj --points points.npy --direction 0,0,1 --json -o o.npy

# Motion goes on over the borders of files: half a unit a frame, of which the first has none.
expect 0 '' render frames/%04d.obj --fps 1 --frames 0:2:5 --aov motion=motion_%d.npy -o out_%d.png --size 16x16 \
    --eye 2,0,9 --at 2,0,0
for frame in 1 2 3 4; do
    moves=$(tail -c 2048 motion_$frame.npy | od -An -v -tf4 -w8 | awk '$1 > 0.1 { n++ } END { print n + 0 }')
    checks=$((checks + 1))
    [ "$moves" -gt 0 ] || fail "motion of frame $frame of a sequence is 0 everywhere"
done

# A floor lies under the first frame that is shown, and the camera shows what it shows without it.
for frame in 0 4.5; do
    expect 0 '' render frames/%04d.obj --fps 1 --time $frame --aov item=plain.npy --size 16x16
    expect 0 '' render frames/%04d.obj --fps 1 --time $frame --aov item=floor.npy --size 16x16 --ground
    python3 - <<'EOF' || fail "at $frame s the floor moves the camera"
ids = [open(name, "rb").read()[-1024:] for name in ("plain.npy", "floor.npy")]
seen = [[k for k in range(256) if data[4 * k:4 * k + 4] == bytes(4)] for data in ids]
assert seen[0] and seen[0] == seen[1], seen
EOF
done

# --- warnings, errors ---------------------------------------------------------------------------
rm frames/0004.obj frames/0005.obj
expect 0 'warning: .*2 of the numbers from 1 to 8 have no file \(the first is frames/0004.obj\)' info frames/%04d.obj
expect 1 'frames/0004.obj' info frames/%04d.obj --strict
printf 'v 0 0 0\nf 1 2 3\n' >frames/0006.obj
expect 1 '0006.obj:2' info frames/%04d.obj
expect 0 '' render frames/%04d.obj --fps 1 --time 1.5 -o a.png --size 16x16
expect 1 '0006.obj:2' render frames/%04d.obj --fps 1 --time 4 -o a.png --size 16x16
for number in 4 5 6; do triangle "frames/000$number.obj" "$number"; done
for number in 3 4 5; do printf 'p 1\n' >>"frames/000$number.obj"; done
expect 0 '2 more such warnings of other frames' render frames/%04d.obj --frames 0:0.25:7 -o out_%d.png --size 16x16
[ "$(grep -c 'points and lines' stderr)" -eq 1 ] || fail "a warning of each frame: $(cat stderr)"
ln -s 0007.obj frames/link.npy
expect 1 'link.npy: cannot write: it would replace the input .frames/0007.obj' \
    render frames/%04d.obj --aov item=frames/link.npy
expect 1 'no file of that pattern, such as frames/1.obj' info frames/%d.obj
expect 1 "cannot be listed" info none/%d.obj
for pattern in %s %n %99999d %d%d %x.obj %-4d %1\$d %hhn '%' '%%%' %*d; do
    expect 1 'exactly one place' info "frames/$pattern"
    expect 1 'exactly one place' render "frames/$pattern.obj" -o a.png
done
expect 1 'no file of that pattern' info "100%%_%d.obj"
expect 2 '--fps' info frames/%04d.obj --fps 0
expect 2 '--fps' info frames/%04d.obj --fps nan
expect 2 '--fps is of numbered files' info builtin:torus --fps 24
triangle '50%d.obj' 0
expect 0 'triangles +1$' info 50%d.obj

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
