#!/usr/bin/env python3
"""project_points_test.py - holds what pixels see against OpenCV's projectPoints. Usage: project_points_test.py PROGRAM

Renders a scene with a calibrated camera (fx other than fy, an off-centre principal point) from a JSON file, takes the
world positions of 1000 pixels, and projects them: each must land on its own pixel. By arithmetic of our own always, and
by OpenCV where Python has cv2 (Debian: python3-opencv), else that part is skipped.
"""
import array
import ast
import json
import math
import os
import random
import subprocess
import sys
import tempfile

WIDTH, HEIGHT = 320, 240
K = [[411.5, 0.0, 141.25], [0.0, 395.75, 133.5], [0.0, 0.0, 1.0]]
AXIS_ANGLE = [0.25, -0.6, 0.1]  # world to camera, as OpenCV's rvec
CENTRE_DEPTH = 5.0
# Positions are floats: at this depth half a unit in their last place is 1e-4 pixels.
TOLERANCE = 5e-4


def rotation(vector):
    """The matrix of Rodrigues' formula."""
    angle = math.sqrt(sum(x * x for x in vector))
    x, y, z = (v / angle for v in vector)
    c, s = math.cos(angle), math.sin(angle)
    return [
        [c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
        [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
        [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)],
    ]


def read_npy(path, code):
    """Shape and values of a little-endian array of format 1.0."""
    with open(path, "rb") as file:
        assert file.read(8) == b"\x93NUMPY\x01\x00"
        length = int.from_bytes(file.read(2), "little")
        header = ast.literal_eval(file.read(length).decode())
        values = array.array(code)
        values.frombytes(file.read())
    return header["shape"], values


def seen_points(program, folder):
    """1000 pixels (i, j) that see something, and the points there."""
    turn = rotation(AXIS_ANGLE)
    camera = os.path.join(folder, "camera.json")
    with open(camera, "w") as file:
        json.dump(
            {"width": WIDTH, "height": HEIGHT, "K": K, "convention": "opencv", "R": turn, "t": [0.1, 0.2, CENTRE_DEPTH]},
            file,
        )
    position, item = os.path.join(folder, "p.npy"), os.path.join(folder, "i.npy")
    command = [program, "render", "builtin:torus", "--camera", camera, "--aov", "position=" + position]
    subprocess.run(command + ["--aov", "item=" + item], check=True)
    shape, p = read_npy(position, "f")
    _, ids = read_npy(item, "I")
    assert shape == (HEIGHT, WIDTH, 3), shape
    hits = [k for k in range(WIDTH * HEIGHT) if ids[k] != 0xFFFFFFFF]
    assert len(hits) > 2000, len(hits)
    chosen = random.Random(1).sample(hits, 1000)
    return [(k % WIDTH, k // WIDTH) for k in chosen], [list(p[3 * k : 3 * k + 3]) for k in chosen]


def projected(points):
    turn = rotation(AXIS_ANGLE)
    places = []
    for point in points:
        x, y, z = (sum(r * v for r, v in zip(row, point)) + t for row, t in zip(turn, (0.1, 0.2, CENTRE_DEPTH)))
        places.append((K[0][0] * x / z + K[0][2], K[1][1] * y / z + K[1][2]))
    return places


def farthest(pixels, places):
    return max(max(abs(a - b) for a, b in zip(pixel, place)) for pixel, place in zip(pixels, places))


def main():
    with tempfile.TemporaryDirectory() as folder:
        pixels, points = seen_points(sys.argv[1], folder)
    off = farthest(pixels, projected(points))
    print(f"1000 points, our arithmetic: at most {off:.2g} pixels off")
    assert off < TOLERANCE, off
    try:
        import cv2
        import numpy
    except ImportError:
        print("skipped: OpenCV's projectPoints (no cv2: apt-get install python3-opencv)")
        return
    places, _ = cv2.projectPoints(
        numpy.array(points), numpy.array(AXIS_ANGLE), numpy.array([0.1, 0.2, CENTRE_DEPTH]), numpy.array(K), None
    )
    off = farthest(pixels, [tuple(place[0]) for place in places])
    print(f"1000 points, OpenCV {cv2.__version__}: at most {off:.2g} pixels off")
    assert off < TOLERANCE, off


if __name__ == "__main__":
    main()
