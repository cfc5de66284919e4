#!/usr/bin/env bash
# camera_cli_test.sh - cameras and lights by files and numbers. Usage: camera_cli_test.sh PROGRAM
# shellcheck source=tests/apps/cli_checks.sh
source "$(dirname "$0")/cli_checks.sh"

size=(--size 60x40)

# --- the same camera in all conventions: the eye at (0, 1, 4), level, looking along -z ---------------
k='"width":60,"height":40,"K":[[70,0,30],[0,70,20],[0,0,1]]'
echo "{$k,\"convention\":\"opengl\",\"camera_to_world\":[[1,0,0,0],[0,1,0,1],[0,0,1,4],[0,0,0,1]]}" >gl.json
echo "{$k,\"convention\":\"blender\",\"camera_to_world\":[[1,0,0,0],[0,1,0,1],[0,0,1,4],[0,0,0,1]]}" >blender.json
echo "{$k,\"convention\":\"opencv\",\"pixel_center\":0.5,\"R\":[[1,0,0],[0,-1,0],[0,0,-1]],\"t\":[0,1,4]}" >cv.json
echo '{"w":60,"h":40,"fl_x":70,"cx":30,"cy":20,"frames":[
  {"file_path":"a","transform_matrix":[[1,0,0,0],[0,1,0,1],[0,0,1,4],[0,0,0,1]]},
  {"file_path":"b","transform_matrix":[[1,0,0,0],[0,1,0,1],[0,0,1,5],[0,0,0,1]]}]}' >transforms.json
mkdir colmap
echo '1 SIMPLE_PINHOLE 60 40 70 30 20' >colmap/cameras.txt
printf '1 0 1 0 0 0 1 4 1 a.png\n\n' >colmap/images.txt
# tan(fov / 2) = 20 / 70.
writes render builtin:torus "${size[@]}" -o by_numbers.exr --eye 0,1,4 --at 0,1,0 --up 0,1,0 --intrinsics 70,70,30,20
for file in gl.json blender.json cv.json colmap colmap/images.txt; do
    writes render builtin:torus --camera $file -o by_file.exr
    same by_file.exr by_numbers.exr "$file"
done
writes render builtin:torus --camera transforms.json --camera-frame 0 -o by_file.exr
same by_file.exr by_numbers.exr transforms.json
writes render builtin:torus --camera transforms.json -o frame_%d.exr
same frame_0.exr by_numbers.exr
checks=$((checks + 1))
cmp -s frame_1.exr frame_0.exr && fail "two cameras of a file make one picture"
writes render builtin:torus "${size[@]}" -o shifted.exr --eye 0,1,4 --at 0,1,0 --intrinsics 70,70,29.5,19.5 --pixel-center 0
same shifted.exr by_numbers.exr "pixel centres"
writes render builtin:torus --camera gl.json --size 120x80 -o twice.exr

# --- which way is which: one triangle at +x and one at +y, seen from +z, in all conventions -----------
printf '%s\n' 'v 1 -.5 0' 'v 2 -.5 0' 'v 1.5 .5 0' 'v -.5 .9 0' 'v .5 .9 0' 'v 0 1.5 0' 'f 1 2 3' 'f 4 5 6' >axes.obj
axes='"width":60,"height":40,"K":[[60,0,30],[0,60,20],[0,0,1]]'
echo "{$axes,\"convention\":\"blender\",\"camera_to_world\":[[1,0,0,0],[0,1,0,0],[0,0,1,5],[0,0,0,1]]}" >axes_blender.json
echo "{$axes,\"convention\":\"opencv\",\"world_to_camera\":[[1,0,0,0],[0,-1,0,0],[0,0,-1,5],[0,0,0,1]]}" >axes_cv.json
echo '{"w":60,"h":40,"fl_x":60,"frames":[{"transform_matrix":[[1,0,0,0],[0,1,0,0],[0,0,1,5],[0,0,0,1]]}]}' >axes_nerf.json
mkdir axes_colmap
echo '1 PINHOLE 60 40 60 60 30 20' >axes_colmap/cameras.txt
printf '1 0 1 0 0 0 0 5 1 a.png\n\n' >axes_colmap/images.txt
for file in axes_blender.json axes_cv.json axes_nerf.json axes_colmap; do
    writes render axes.obj --camera $file --aov item=axes.npy
    python3 - <<'EOF' || fail "$file: +x is not right, or +y not up"
import array
with open("axes.npy", "rb") as file:
    data = file.read()
a = array.array("I"); a.frombytes(data[-4 * 40 * 60:])
at = lambda x, y: a[y * 60 + x]
# (1.5, 0, 0) is at column 30 + 60 * 1.5 / 5 = 48 of row 20; (0, 1.1, 0) at column 30 of row 20 - 60 * 1.1 / 5 = 7.
assert at(48, 20) == 0 and at(30, 6) == 1, (at(48, 20), at(30, 6))
assert at(12, 20) == at(30, 33) == 0xFFFFFFFF
EOF
done

# --- a region is a part of the picture ----------------------------------------------------------
writes render builtin:torus --camera gl.json --region 20,10,30,20 --aov item=part.npy --aov depth=part_depth.npy
writes render builtin:torus --camera gl.json --aov item=all.npy
python3 - <<'EOF' || fail "a region is not the picture's part"
import array
def ids(path, shape):
    with open(path, "rb") as file:
        data = file.read()
    a = array.array("I"); a.frombytes(data[-4 * shape[0] * shape[1]:])
    return [list(a[y * shape[1]:(y + 1) * shape[1]]) for y in range(shape[0])]
assert ids("part.npy", (20, 30)) == [row[20:50] for row in ids("all.npy", (40, 60))[10:30]]
EOF
refuses 1 'region' render builtin:torus --camera gl.json --region 50,10,30,20 -o a.png

# --- a path -------------------------------------------------------------------------------------
echo '{"fps":4,"keys":[{"time":0,"eye":[0,1,4],"target":[0,1,0],"fov":32},{"time":1,"eye":[4,1,0],"target":[0,1,0]}]}' >path.json
writes render builtin:torus "${size[@]}" --camera-path path.json -o path_%d.png
[ "$(ls path_*.png | wc -l)" -eq 5 ] || fail "a path of a second at 4 a second has $(ls path_*.png)"
grep -q 'nothing moves' stderr && fail "a camera that moves is warned of"
writes render builtin:torus "${size[@]}" --camera-path path.json --time 1 -o end.png
same end.png path_4.png

# --- masks and triangles of such cameras -----------------------------------------------------------
numbers=(--size 60x40 --eye 0,1,4 --at 0,1,0 --up 0,1,0 --intrinsics 70,70,30,20)
writes mask builtin:torus "${numbers[@]}" -o by_numbers.json
writes mask builtin:torus --camera gl.json -o by_file.json
same by_file.json by_numbers.json "masks by a camera's file"
writes mask builtin:torus --camera transforms.json --camera-frame 0 -o by_file.json
same by_file.json by_numbers.json "masks by one camera of a file"
writes mask builtin:torus --camera transforms.json --picture p_%d.png -o two.json
expect 0 '' mask builtin:torus --camera transforms.json --picture p_%d.png -o -
grep -q 'p_1.png' stdout || fail "two cameras make no second picture: $(head -c 300 stdout)"
writes visible builtin:torus "${numbers[@]}" -o by_numbers.csv
writes visible builtin:torus --camera gl.json -o by_file.csv
same by_file.csv by_numbers.csv "triangles seen by a camera's file"
writes visible builtin:torus --camera gl.json --region 0,0,30,40 -o left.csv
writes visible builtin:torus --camera gl.json --region 30,0,30,40 -o right.csv
checks=$((checks + 1))
[ "$(cat left.csv right.csv | awk -F, '/^[0-9]/ { n += $3 } END { print n }')" = \
    "$(awk -F, '/^[0-9]/ { n += $3 } END { print n }' by_file.csv)" ] || fail "two halves are not the whole"
writes visible builtin:torus "${size[@]}" --camera-path path.json -o path.json.csv
refuses 1 "gl.json: .*the input" mask builtin:torus --camera gl.json -o gl.json
refuses 1 "gl.json.*the input" visible builtin:torus --camera gl.json --output-format json -o gl.json
refuses 2 'accepted are as many' mask builtin:torus --camera transforms.json --frames 0:1:3 -o m.json
refuses 2 'exactly one place' mask builtin:torus --camera transforms.json --picture p.png -o m.json
refuses 2 'say it or --eye' visible builtin:torus --camera gl.json --eye 0,0,3

# --- wrong input --------------------------------------------------------------------------------
echo "{$k,\"convention\":\"opengl\",\"camera_to_world\":[[1,0,0,0],[0,1,0,1],[0,0,-1,4],[0,0,0,1]]}" >left.json
echo "{$k,\"convention\":\"opengl\",\"distortion\":[0.1],\"camera_to_world\":[[1,0,0,0],[0,1,0,1],[0,0,1,4],[0,0,0,1]]}" >bent.json
refuses 1 'left.json: camera_to_world: left-handed' render builtin:torus --camera left.json -o a.png
refuses 1 'bent.json: distortion: a coefficient of distortion is 0.1' render builtin:torus --camera bent.json -o a.png
refuses 1 'none.json: no such file' render builtin:torus --camera none.json -o a.png
refuses 1 'no such file' render builtin:torus --camera-path none.json -o a.png
refuses 2 'exactly one place' render builtin:torus --camera transforms.json -o a.png
refuses 2 'accepted are 0 to 1' render builtin:torus --camera transforms.json --camera-frame 2 -o a.png
refuses 2 'say it or --eye' render builtin:torus --camera gl.json --eye 0,0,3 -o a.png
refuses 2 'say one' render builtin:torus --camera gl.json --camera-path path.json -o a.png
refuses 2 'say --camera FILE too' render builtin:torus --camera-frame 1 -o a.png
refuses 2 'accepted are as many' render builtin:torus --camera transforms.json --frames 0:1:3 -o a_%d.png
refuses 2 'accepted are fx,fy,cx,cy' render builtin:torus --intrinsics 0,1,2,3 -o a.png
refuses 2 'accepted are 0 \(as OpenCV\) and 0.5' render builtin:torus --pixel-center 1 -o a.png
refuses 2 'accepted is x,y,width,height' render builtin:torus --region 0,0,0,5 -o a.png
refuses 1 'path.json: .*the input' render builtin:torus --camera-path path.json --stats-json path.json --aov item=i_%d.npy

# --- orthographic cameras -----------------------------------------------------------------------
writes render builtin:torus "${size[@]}" -o zoomed.exr --ortho 3 --zoom 1.5
writes render builtin:torus "${size[@]}" -o flat.exr --ortho 2
same zoomed.exr flat.exr "a picture that is 1.5 times as large"
writes render builtin:torus "${size[@]}" -o fit.exr --ortho fit --view top --shadows map --sky 0
writes render builtin:torus "${size[@]}" -o eye.exr --ortho 3 --eye 0,4,0.1 --at 0,0,0
refuses 2 '--ortho and --fov exclude each other' render builtin:torus --ortho 3 --fov 40 -o a.png
refuses 2 '--ortho and --intrinsics exclude' render builtin:torus --ortho 3 --intrinsics 9,9,1,1 -o a.png
refuses 2 'is no height of an orthographic picture' render builtin:torus --ortho 0 -o a.png
refuses 2 'say it or --ortho' render builtin:torus --camera transforms.json --ortho 3 -o a.png
refuses 1 'rendered by the cpu engine alone' render builtin:torus --ortho 3 --engine gpu -o a.png

# A triangle, and a camera at (0, 0, 2) whose picture is 3 high. Of glTF's camera ymag counts.
printf '\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0' >flat.bin
echo '{"asset":{"version":"2.0"},"buffers":[{"uri":"flat.bin","byteLength":36}],
  "bufferViews":[{"buffer":0,"byteLength":36}],
  "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
  "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
  "cameras":[{"type":"orthographic","orthographic":{"xmag":9,"ymag":1.5,"znear":0,"zfar":9}}],
  "nodes":[{"mesh":0},{"camera":0,"translation":[0,0,2]}],"scenes":[{"nodes":[0,1]}],"scene":0}' >flat.gltf
writes render flat.gltf "${size[@]}" -o own.exr
writes render flat.gltf "${size[@]}" -o said.exr --ortho 3 --eye 0,0,2 --at 0,0,0
same own.exr said.exr "the camera of a glTF"
expect 0 '"orthographic_height": 3' info flat.gltf --json

# --- compare takes them too -----------------------------------------------------------------------
writes compare builtin:torus --against brute "${size[@]}" --ortho 2 --shadows exact --light point:0,9e7,1e7
writes compare builtin:torus --against brute --camera transforms.json --region 3,2,20,10 --light sun:52.5,13.4,2026-06-21T12:00+02:00
refuses 2 'accepted is x,y,width,height' compare builtin:torus --against brute --region 1 --light point:0,1,0

# --- lights -------------------------------------------------------------------------------------
writes render builtin:torus "${size[@]}" -o old.exr --light point:0,5,0
writes render builtin:torus "${size[@]}" -o new.exr --light point:0,5,0,color=1,1,1,intensity=1,falloff=none
same old.exr new.exr
writes render builtin:torus "${size[@]}" -o lamp.exr --eye 0,1,4 --at 0,1,0 --light camera:point:1,2,0
writes render builtin:torus "${size[@]}" -o world.exr --eye 0,1,4 --at 0,1,0 --light point:1,3,4
same lamp.exr world.exr "a light on the camera"
writes render builtin:torus "${size[@]}" -o sun.exr --light sun:52.5,13.4,2026-06-21T12:00+02:00
refuses 2 'below the horizon' render builtin:torus -o a.png --light sun:52.5,13.4,2026-06-21T00:00Z
refuses 2 'accepted are none and square' render builtin:torus -o a.png --light point:0,5,0,falloff=cube

# --- hours of sun -------------------------------------------------------------------------------
# A point in the open, and one under a roof of 20 x 20 at height 1.
printf '%s\n' 'v -10 1 -10' 'v 10 1 -10' 'v 10 1 10' 'v -10 1 10' 'f 1 2 3 4' >roof.obj
printf '\x93NUMPY\x01\x00\x46\x00%-69s\n' "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }" >points.npy
printf '\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x7a\x44\x00\x00\x00\x00\x00\x00\x00\x00' >>points.npy
day=0,0,2026-03-20T00:00Z,2026-03-21T00:00Z
writes occlusion roof.obj --points points.npy --sun $day,10m --hours -o hours.csv --json
checks=$((checks + 1))
[ "$(sed -n 3p hours.csv)" = 1000,0,0,12.0000 ] || fail "an equinox at the equator: $(cat hours.csv)"
# Under the roof the sun comes in below atan(1 / 10) = 5.71 degrees: 23 minutes in the morning and in the evening.
sed -n 2p hours.csv | grep -qE '^0,0,0,(0.6667|0.8333|1.0000)$' || fail "under a roof: $(cat hours.csv)"
writes occlusion roof.obj --points points.npy --sun $day,1h -o rows.csv
[ "$(head -1 rows.csv | tr ',' '\n' | wc -l)" -eq 27 ] || fail "a column for each step: $(head -1 rows.csv)"
writes occlusion roof.obj --points points.npy --sun $day,1h --hours -o hours.npy
writes occlusion roof.obj --points points.npy --light sun:0,0,2026-03-20T12:00Z -o noon.npy
refuses 2 'accepted is LAT,LON,FROM,TO,STEP' occlusion roof.obj --points points.npy --sun 0,0,x -o a.npy
refuses 2 'is of --sun' occlusion roof.obj --points points.npy --direction 0,-1,0 --hours -o a.npy
refuses 2 'there is no camera here' occlusion roof.obj --points points.npy --light camera:point:0,0,0 -o a.npy
refuses 2 'accepted are .npy and .csv' occlusion roof.obj --points points.npy --direction 0,-1,0 -o a.txt

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
