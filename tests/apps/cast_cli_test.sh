#!/usr/bin/env bash
# cast_cli_test.sh - rays from files, and the archive of what they hit. Usage: cast_cli_test.sh PROGRAM
# shellcheck source=tests/apps/cli_checks.sh
source "$(dirname "$0")/cli_checks.sh"

# A square of two triangles at z = 0, another at z = -1 that only (0, 0) to (1, 1) has.
printf '%s\n' 'v -1 -1 0' 'v 1 -1 0' 'v 1 1 0' 'v -1 1 0' 'f 1 2 3' 'f 1 3 4' \
    'o back' 'v 0 0 -1' 'v 1 0 -1' 'v 1 1 -1' 'v 0 1 -1' 'f 5 6 7' 'f 5 7 8' >squares.obj
python3 - <<'EOF'
import struct
def npy(path, descr, shape, code, values):
    head = "{'descr': '%s', 'fortran_order': False, 'shape': %s, }" % (descr, shape)
    head += " " * ((64 - (11 + len(head)) % 64) % 64) + "\n"
    with open(path, "wb") as file:
        file.write(b"\x93NUMPY\x01\0" + struct.pack("<H", len(head)) + head.encode())
        file.write(struct.pack("<%d%s" % (len(values), code), *values))
down = (0, 0, -2)
rays = [(.5, .25, 3) + down, (-.5, .25, 3) + down, (.5, .25, -.5) + down, (5, 5, 5) + down, (0, 0, 1, 0, 0, 0),
        (float("nan"), 0, 1, 0, 0, -1)]
npy("rays.npy", "<f4", (6, 6), "f", [x for ray in rays for x in ray])
npy("rays64.npy", "<f8", (6, 6), "d", [x for ray in rays for x in ray])
npy("origins.npy", "<f4", (6, 3), "f", [x for ray in rays for x in ray[:3]])
npy("down.npy", "<f4", (1, 3), "f", down)
npy("skip.npy", "<i8", (6,), "q", [0, -1, -1, -1, -1, -1])
npy("skip_far.npy", "<i8", (6,), "q", [99] + [-1] * 5)
npy("two.npy", "<i8", (2,), "q", [0, 1])
EOF

# holds FILE EXPRESSION : what an archive has, read by Python alone: a[name] is (type, shape, values).
holds()
{
    checks=$((checks + 1))
    python3 - "$1" "$2" <<'EOF' || fail "$1: not $2"
import ast, struct, sys, zipfile
codes = {"<f4": "f", "<u4": "I", "<u8": "Q", "|b1": "?"}
a = {}
with zipfile.ZipFile(sys.argv[1]) as archive:
    assert archive.testzip() is None
    for name in archive.namelist():
        data = archive.read(name)
        length = struct.unpack("<H", data[8:10])[0]
        head = ast.literal_eval(data[10:10 + length].decode())
        body = data[10 + length:]
        code = codes[head["descr"]]
        values = struct.unpack("<%d%s" % (len(body) // struct.calcsize(code), code), body)
        a[name[:-4]] = (head["descr"], head["shape"], list(values))
inf, none = float("inf"), 0xFFFFFFFF
if not eval(sys.argv[2]):
    print(a)
    sys.exit(1)
EOF
}

writes cast squares.obj --rays rays.npy -o hits.npz
holds hits.npz 'a["t"] == ("<f4", (6,), [1.5, 1.5, .25, inf, inf, inf])'
holds hits.npz 'a["triangle"] == ("<u4", (6,), [0, 1, 2, none, none, none])'
holds hits.npz 'a["instance"] == ("<u4", (6,), [0, 0, 1, none, none, none])'
holds hits.npz 'a["uv"] == ("<f4", (6, 2), [.125, .625, .25, .375, .25, .25] + [0] * 6)'
holds hits.npz 'a["normal"] == ("<f4", (6, 3), [0, 0, 1] * 3 + [0] * 9)'
writes cast squares.obj --rays rays64.npy -o doubles.npz
same doubles.npz hits.npz "rays as doubles"
writes cast squares.obj --rays rays.npy --threads 3 -o threads.npz
same threads.npz hits.npz "three threads"
writes cast squares.obj --origins origins.npy --directions down.npy -o pairs.npz
holds pairs.npz 'a["triangle"][2] == [0, 1, 2, none, 0, none]'
writes cast squares.obj --rays rays.npy --any -o any.npz
holds any.npz 'a == {"hit": ("|b1", (6,), [True] * 3 + [False] * 3)}'
writes cast squares.obj --rays rays.npy --count -o count.npz
holds count.npz 'a == {"count": ("<u4", (6,), [2, 1, 1, 0, 0, 0])}'
expect 0 '"hits": 4' cast squares.obj --rays rays.npy --all -o all.npz --json
holds all.npz 'a["first"] == ("<u8", (7,), [0, 2, 3, 4, 4, 4, 4])'
holds all.npz 'a["t"][2] == [1.5, 2, 1.5, .25] and a["triangle"][2] == [0, 2, 1, 2]'
writes cast squares.obj --rays rays.npy --skip skip.npy -o skip.npz
holds skip.npz 'a["triangle"][2][:3] == [2, 1, 2]'
writes cast squares.obj --rays rays.npy --tmin 1.75 -o tmin.npz
holds tmin.npz 'a["triangle"][2][:3] == [2, none, none]'
writes cast squares.obj --rays rays.npy --tmax 1.5 -o tmax.npz
holds tmax.npz 'a["triangle"][2][:3] == [0, 1, 2]'
writes cast squares.obj --rays rays.npy --tmax 1.4999 -o tmax.npz
holds tmax.npz 'a["triangle"][2][:3] == [none, none, 2]'
expect 0 'cast +[0-9.]+ ms' cast builtin:robots --rays rays.npy --time 2 --clip none --stats -o robots.npz

# --- what is refused ----------------------------------------------------------------------------
refuses 2 'no rays' cast squares.obj -o a.npz
refuses 2 'directions' cast squares.obj --origins origins.npy -o a.npz
refuses 2 'excludes' cast squares.obj --rays rays.npy --origins origins.npy --directions down.npy -o a.npz
refuses 2 'accepted is .npz' cast squares.obj --rays rays.npy -o a.npy
refuses 2 'output' cast squares.obj --rays rays.npy
refuses 2 'excludes' cast squares.obj --rays rays.npy --any --all -o a.npz
refuses 2 'nothing is between' cast squares.obj --rays rays.npy --tmin 2 --tmax 1 -o a.npz
refuses 2 '--tmax: ' cast squares.obj --rays rays.npy --tmax far -o a.npz
refuses 1 'only \(N, 6\)' cast squares.obj --rays origins.npy -o a.npz
refuses 1 'only \(N, 3\)' cast squares.obj --origins rays.npy --directions down.npy -o a.npz
refuses 1 'none.npy: no such file' cast squares.obj --rays none.npy -o a.npz
refuses 1 '2 triangles to skip for 6 rays' cast squares.obj --rays rays.npy --skip two.npy -o a.npz
refuses 1 'ray 0: 99 is no triangle to skip: the scene has 4' cast squares.obj --rays rays.npy --skip skip_far.npy -o a.npz
refuses 1 'no such folder|does not exist|no folder' cast squares.obj --rays rays.npy -o nowhere/a.npz
cp rays.npy rays.npz
refuses 1 'rays.npz' cast squares.obj --rays rays.npz -o rays.npz

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
