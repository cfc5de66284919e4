#!/usr/bin/env python3
"""masks_test.py - masks by an independent reader: equal to the planes, and shares to renders of each object alone.

Usage: masks_test.py PROGRAM
"""
import ast
import csv
import json
import random
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = str(Path(sys.argv.pop(1)).resolve())
NONE = 0xFFFFFFFF


def run(folder, *words, code=0):
    """The program's standard output; its exit code has to be `code`."""
    done = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, timeout=300)
    assert done.returncode == code, f"{words}: {done.returncode}: {done.stderr.decode()}"
    return done.stdout if code == 0 else done.stderr.decode()


def read_npy(path):
    """The rows of an array of unsigned integers, and its shape."""
    data = Path(path).read_bytes()
    assert data[:8] == b"\x93NUMPY\x01\x00"
    (length,) = struct.unpack_from("<H", data, 8)
    assert (10 + length) % 64 == 0
    head = ast.literal_eval(data[10:10 + length].decode())
    assert not head["fortran_order"]
    kind = {"<u4": "I", "<u8": "Q"}[head["descr"]]
    count = 1
    for side in head["shape"]:
        count *= side
    values = struct.unpack_from(f"<{count}{kind}", data, 10 + length)
    return values, head["shape"]


def decoded_text(text):
    """COCO's compressed counts: five bits a character, the lowest first; differences to two before."""
    counts, place = [], 0
    while place < len(text):
        number, shift = 0, 0
        while True:
            bits = ord(text[place]) - 48
            assert 0 <= bits < 64
            place += 1
            number |= (bits & 31) << shift
            shift += 5
            if not bits & 32:
                break
        if bits & 16:  # negative
            number -= 1 << shift
        if len(counts) > 2:
            number += counts[-2]
        counts.append(number)
    return counts


def pixels_of(segmentation):
    """The set of (row, column) of a mask."""
    height, width = segmentation["size"]
    counts = segmentation["counts"]
    if isinstance(counts, str):
        counts = decoded_text(counts)
    assert sum(counts) == height * width
    assert all(count > 0 for count in counts[1:])
    pixels, place = set(), 0
    for turn, count in enumerate(counts):
        if turn % 2:
            pixels.update((k % height, k // height) for k in range(place, place + count))
        place += count
    return pixels


def write_scene(path, objects, chosen=None):
    """An OBJ of triangles, all objects of it or one."""
    lines, vertex = [], 1
    for number, triangles in enumerate(objects):
        if chosen is not None and number != chosen:
            continue
        lines.append(f"o thing{number}")
        for triangle in triangles:
            for x, y, z in triangle:
                lines.append(f"v {x} {y} {z}")
            lines.append(f"f {vertex} {vertex + 1} {vertex + 2}")
            vertex += 3
    Path(path).write_text("\n".join(lines) + "\n")


def random_objects(count, seed):
    draw = random.Random(seed)
    objects = []
    for _ in range(count):
        middle = [draw.uniform(-2, 2) for _ in range(3)]
        objects.append([[[round(c + draw.uniform(-0.9, 0.9), 3) for c in middle] for _ in range(3)]
                        for _ in range(6)])
    # One that is hidden behind another, and one behind the eye.
    objects.append([[[-9, -9, -5], [9, -9, -5], [0, 9, -5]]])
    objects.append([[[-0.1, -0.1, -6], [0.1, -0.1, -6], [0, 0.1, -6]]])
    objects.append([[[-9, -9, 20], [9, -9, 20], [0, 9, 20]]])
    return objects


VIEW = ["--eye", "0.3,0.2,5", "--at", "0,0,0", "--up", "0,1,0", "--fov", "50"]


class Masks(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def masks(self, *words):
        run(self.path, "mask", *words, "-o", "masks.json")
        return json.loads((self.path / "masks.json").read_text())

    def check_against_plane(self, document, plane, shape, key):
        seen = {}
        for place, identity in enumerate(plane):
            if identity != NONE:
                seen.setdefault(identity, set()).add((place // shape[1], place % shape[1]))
        self.assertGreater(len(seen), 1)
        self.assertEqual([a[key] for a in document["annotations"]], sorted(seen))
        for annotation in document["annotations"]:
            pixels = pixels_of(annotation["segmentation"])
            self.assertEqual(annotation["segmentation"]["size"], list(shape))
            self.assertEqual(pixels, seen[annotation[key]])
            self.assertEqual(annotation["area"], len(pixels))
            rows, columns = zip(*pixels)
            self.assertEqual(annotation["bbox"], [min(columns), min(rows), max(columns) - min(columns) + 1,
                                                  max(rows) - min(rows) + 1])
            self.assertEqual(annotation["iscrowd"], 0)

    def test_masks_are_the_planes(self):
        for size in ("160x90", "33x70", "1x50", "50x1"):
            for kind in ("instance", "node", "material"):
                view = ["builtin:robots", "--size", size, "--time", "3"]
                run(self.path, "render", *view, "--aov", f"{kind}=plane.npy")
                plane, shape = read_npy(self.path / "plane.npy")
                for counts in ("compressed", "list"):
                    document = self.masks(*view, "--by", kind, "--counts", counts)
                    if len(set(plane) - {NONE}) > 1:
                        self.check_against_plane(document, plane, shape, kind)

    def test_shares_are_those_of_renders_of_each_object_alone(self):
        for seed in (1, 2):
            objects = random_objects(12, seed)
            write_scene(self.path / "all.obj", objects)
            view = [*VIEW, "--size", "120x80"]
            document = self.masks("all.obj", *view)
            run(self.path, "render", "all.obj", *view, "--aov", "instance=all.npy")
            plane, _ = read_npy(self.path / "all.npy")
            told = {a["instance"]: a for a in document["annotations"]}
            hidden = {h["instance"]: h for h in document["images"][0]["hidden"]}
            partly = 0
            for number in range(len(objects)):
                write_scene(self.path / "one.obj", objects, number)
                run(self.path, "render", "one.obj", *view, "--aov", "item=one.npy")
                alone = sum(item != NONE for item in read_npy(self.path / "one.npy")[0])
                seen = sum(identity == number for identity in plane)
                if seen:
                    self.assertEqual(told[number]["pixels_alone"], alone)
                    self.assertEqual(told[number]["area"], seen)
                    self.assertEqual(told[number]["visibility"], seen / alone)
                    self.assertEqual(told[number]["name"], f"thing{number}")
                    partly += 0 < seen < alone
                else:
                    self.assertNotIn(number, told)
                    self.assertEqual(hidden[number]["pixels_alone"] if number in hidden else 0, alone)
            self.assertGreater(partly, 5)
            self.assertIn(13, hidden)
            self.assertNotIn(14, hidden)

    def test_frames_are_images(self):
        document = self.masks("builtin:robots", "--size", "60x40", "--frames", "0:2:3", "--picture", "f_%03d.png")
        self.assertEqual([i["file_name"] for i in document["images"]], ["f_000.png", "f_001.png", "f_002.png"])
        self.assertEqual([i["time_s"] for i in document["images"]], [0, 1, 2])
        self.assertEqual([i["id"] for i in document["images"]], [1, 2, 3])
        numbers = [a["id"] for a in document["annotations"]]
        self.assertEqual(numbers, list(range(1, len(numbers) + 1)))
        self.assertEqual({a["image_id"] for a in document["annotations"]}, {1, 2, 3})
        categories = {c["id"] for c in document["categories"]}
        self.assertLessEqual({a["category_id"] for a in document["annotations"]}, categories)

    def test_triangles_that_are_seen(self):
        view = ["builtin:robots", "--size", "160x90", "--time", "3"]
        run(self.path, "render", *view, "--aov", "item=item.npy", "--aov", "instance=instance.npy")
        items, owners = read_npy(self.path / "item.npy")[0], read_npy(self.path / "instance.npy")[0]
        expected = {}
        for item, owner in zip(items, owners):
            if item != NONE:
                expected[item] = (owner, expected.get(item, (0, 0))[1] + 1)
        rows = list(csv.DictReader(run(self.path, "visible", *view).decode().splitlines()))
        self.assertEqual({int(r["triangle"]): (int(r["instance"]), int(r["pixels"])) for r in rows}, expected)
        self.assertEqual([int(r["triangle"]) for r in rows], sorted(expected))
        run(self.path, "visible", *view, "-o", "seen.json")
        seen = json.loads((self.path / "seen.json").read_text())
        self.assertEqual({v["triangle"]: (v["instance"], v["pixels"]) for v in seen["visible"]}, expected)
        self.assertEqual(seen["seen"], len(expected))
        self.assertEqual(seen["pixels"], 160 * 90)
        run(self.path, "visible", *view, "-o", "seen.npy")
        counts, shape = read_npy(self.path / "seen.npy")
        self.assertEqual(shape, (seen["triangles"],))
        self.assertEqual({k: n for k, n in enumerate(counts) if n}, {k: n for k, (_, n) in expected.items()})

    def test_several_frames_are_added_up(self):
        view = ["builtin:torus", "--size", "40x40"]
        one = json.loads(run(self.path, "visible", *view, "--output-format", "json"))
        two = json.loads(run(self.path, "visible", *view, "--frames", "0:0:2", "--output-format", "json"))
        self.assertEqual(two["frames"], 2)
        self.assertEqual([v["pixels"] for v in two["visible"]], [2 * v["pixels"] for v in one["visible"]])

    def test_nothing_seen_is_no_error(self):
        away = ["builtin:torus", "--size", "20x10", "--eye", "0,0,100", "--at", "0,0,200"]
        document = self.masks(*away)
        self.assertEqual(document["annotations"], [])
        self.assertEqual(document["images"][0]["hidden"], [])
        self.assertEqual(run(self.path, "visible", *away), b"triangle,instance,pixels\n")

    def test_a_full_disk_is_an_error(self):
        for name in ("full.json", "full.csv", "full.npy", "full.exr"):
            (self.path / name).symlink_to("/dev/full")
        small = ["builtin:torus", "--size", "20x10"]
        for words in (["mask", *small, "-o", "full.json"], ["visible", *small, "-o", "full.csv"],
                      ["visible", *small, "-o", "full.npy"], ["render", *small, "--exr", "full.exr"],
                      ["render", *small, "--manifest", "full.json"]):
            self.assertIn("cannot write: No space left", run(self.path, *words, code=1), words)
        self.assertEqual(len(list(self.path.iterdir())), 4)

    def test_inputs_stay(self):
        write_scene(self.path / "s.json", random_objects(1, 1))
        (self.path / "s.obj").symlink_to("s.json")
        before = (self.path / "s.json").read_bytes()
        for words in (["mask", "s.obj", "-o", "s.json"], ["visible", "s.obj", "-o", "s.json"],
                      ["render", "s.obj", "--size", "9x9", "--manifest", "s.json"]):
            self.assertIn("it would replace the input", run(self.path, *words, code=1), words)
        self.assertEqual((self.path / "s.json").read_bytes(), before)

    def test_a_manifest_names_the_ids(self):
        run(self.path, "render", "builtin:robots", "--size", "40x40", "--aov", "instance=i.npy",
            "--manifest", "ids.json")
        manifest = json.loads((self.path / "ids.json").read_text())
        info = json.loads(run(self.path, "info", "builtin:robots", "--json"))
        self.assertEqual(manifest["none"], NONE)
        for kind in ("instances", "nodes", "materials"):
            self.assertEqual([e["id"] for e in manifest[kind]], list(range(len(info[kind]))))
            self.assertEqual([e["name"] for e in manifest[kind]], [e["name"] for e in info[kind]])
            colors = [e["color"] for e in manifest[kind]]
            self.assertEqual(len(set(colors)), len(colors))
            for color in colors:
                self.assertRegex(color, "^#[0-9a-f]{6}$")
                self.assertNotEqual(color, "#000000")

    def test_wrong_words_are_refused(self):
        before = sorted(self.path.iterdir())
        for words, code, pattern in [
                (["mask", "builtin:torus"], 2, "--output"),
                (["mask", "builtin:torus", "-o", "a.json", "--by", "pixel"], 2, "instance, node and material"),
                (["mask", "builtin:torus", "-o", "a.json", "--counts", "none"], 2, "compressed or list"),
                (["mask", "builtin:torus", "-o", "none/a.json"], 1, "folder 'none' does not exist"),
                (["mask", "builtin:torus", "-o", "a.json", "--frames", "0:1:2", "--picture", "a.png"], 2, "exactly one"),
                (["mask", "builtin:torus", "-o", "a.json", "--frames", "5-3"], 2, "no choice of frames"),
                (["mask", "builtin:torus", "-o", "a.json", "--fps", "3"], 2, "--fps is of numbered files"),
                (["mask", "builtin:torus", "-o", "a.json", "--size", "65536x65536"], 1, "too many"),
                (["mask", "builtin:torus", "-o", "a.json", "--size", "0x5"], 2, "--size"),
                (["visible", "builtin:torus", "--size", "100000x5"], 2, "--size"),
                (["mask", "builtin:torus", "-o", "a.json", "--time", "nan"], 2, "--time"),
                (["visible", "builtin:torus", "--frames", "0:nan:3"], 2, "--frames"),
                (["mask", "builtin:torus", "-o", ""], 1, "without a name"),
                (["mask", "none.obj", "-o", "a.json"], 1, "none.obj: no such file"),
                (["visible", "builtin:torus", "-o", "a.txt"], 2, "accepted are .csv, .json and .npy"),
                (["visible", "builtin:torus", "--output-format", "exr"], 2, "csv, json and npy"),
                (["visible", "builtin:torus", "-o", "none/a.csv"], 1, "folder 'none' does not exist"),
                (["render", "builtin:torus", "-o", "a.png", "--manifest", "none/a.json"], 1, "folder 'none'"),
                (["render", "builtin:torus", "-o", "a.png", "--manifest", "a.png"], 2, "written twice")]:
            self.assertIn(pattern, run(self.path, *words, code=code), words)
        self.assertEqual(sorted(self.path.iterdir()), before)


if __name__ == "__main__":
    unittest.main()
