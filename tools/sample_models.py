#!/usr/bin/env python3
"""sample_models.py - writes small models of the kinds that people have, for pictures and comparisons.

Usage: sample_models.py FOLDER. Writes bracket.stl, ball.stl, heat.ply, crate.obj (with crate.mtl and crate.png),
town.ply, spheres.gltf, leaves.gltf and wheel.gltf. Python's standard library alone; the same bytes every time.
"""

import base64
import json
import math
import pathlib
import random
import struct
import sys
import zlib


def box(low, high):
    """Twelve triangles (lists of three points), counter-clockwise from outside."""
    x0, y0, z0 = low
    x1, y1, z1 = high
    corners = [(x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    triangles = []
    for a, b, c, d in faces:
        triangles.append([corners[a], corners[b], corners[c]])
        triangles.append([corners[a], corners[c], corners[d]])
    return triangles


def sphere(rings, sectors, radius=1.0, center=(0.0, 0.0, 0.0)):
    """Points, normals and index triples of a sphere around the z axis."""
    points, normals, triangles = [], [], []
    for i in range(rings + 1):
        down = math.pi * i / rings
        for j in range(sectors):
            around = 2 * math.pi * j / sectors
            n = (math.sin(down) * math.cos(around), math.sin(down) * math.sin(around), math.cos(down))
            normals.append(n)
            points.append(tuple(c + radius * k for c, k in zip(center, n)))
    for i in range(rings):
        for j in range(sectors):
            a, b = i * sectors + j, i * sectors + (j + 1) % sectors
            c, d = a + sectors, b + sectors
            if i > 0:
                triangles.append((a, c, b))
            if i < rings - 1:
                triangles.append((b, c, d))
    return points, normals, triangles


def write_stl(path, triangles):
    """Binary STL; programs compute the facets' normals."""
    data = bytearray(path.stem.encode().ljust(80, b"\0") + struct.pack("<I", len(triangles)))
    for triangle in triangles:
        data += struct.pack("<3f", 0, 0, 0)
        for corner in triangle:
            data += struct.pack("<3f", *corner)
        data += b"\0\0"
    path.write_bytes(bytes(data))


def bracket():
    """An angle bracket: two plates, the lying one with a round hole, and a rib."""
    triangles = box((0, 0, 0.6), (0.6, 4, 3.6)) + box((0.6, 1.8, 0.6), (2.2, 2.2, 1.0))
    steps, radius, centre, thickness = 48, 0.8, (2.6, 2.0), 0.6

    def rim(k):
        angle = 2 * math.pi * k / steps
        return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)

    def edge(k):  # the same direction on the plate's outline
        angle = 2 * math.pi * k / steps
        dx, dy = math.cos(angle), math.sin(angle)
        ways = [((4 if dx > 0 else 0) - centre[0]) / dx if abs(dx) > 1e-12 else math.inf,
                ((4 if dy > 0 else 0) - centre[1]) / dy if abs(dy) > 1e-12 else math.inf]
        way = min(ways)
        return centre[0] + way * dx, centre[1] + way * dy

    corners = [math.atan2(y - centre[1], x - centre[0]) for x, y in ((4, 4), (0, 4), (0, 0), (4, 0))]
    outline = [(x, y) for x, y in ((4, 4), (0, 4), (0, 0), (4, 0))]
    for k in range(steps):
        a, b, c, d = rim(k), rim(k + 1), edge(k), edge(k + 1)
        low, high = 2 * math.pi * k / steps, 2 * math.pi * (k + 1) / steps
        between = [p for p, angle in zip(outline, corners) if low < angle % (2 * math.pi) < high]
        ring = [a, c] + between + [d, b]
        for top in (True, False):
            z = thickness if top else 0.0
            flat = [(x, y, z) for x, y in ring]
            for m in range(1, len(flat) - 1):
                triangle = [flat[0], flat[m], flat[m + 1]]
                triangles.append(triangle if top else triangle[::-1])
        for p, q in zip(ring[1:-2], ring[2:-1]):  # the outer side
            triangles += [[(*p, 0.0), (*q, 0.0), (*q, thickness)], [(*p, 0.0), (*q, thickness), (*p, thickness)]]
        triangles += [[(*b, 0.0), (*a, 0.0), (*a, thickness)], [(*b, 0.0), (*a, thickness), (*b, thickness)]]
    return triangles


def write_heat(path):
    """A PLY sheet of 80 x 80 quads whose vertices are coloured by their height."""
    side = 81
    lines = ["ply", "format ascii 1.0", f"element vertex {side * side}"]
    lines += [f"property float {axis}" for axis in "xyz"]
    lines += [f"property uchar {name}" for name in ("red", "green", "blue")]
    lines += [f"element face {2 * (side - 1) ** 2}", "property list uchar int vertex_indices", "end_header"]
    for j in range(side):
        for i in range(side):
            x, y = i / 40 - 1, j / 40 - 1
            z = 0.35 * math.sin(5 * x) * math.cos(4 * y) * math.exp(-x * x - y * y)
            t = z / 0.5 + 0.5
            color = [round(255 * min(1, max(0, c))) for c in (1.5 * t, 1 - abs(2 * t - 1), 1.5 - 1.5 * t)]
            lines.append(f"{x:.4f} {y:.4f} {z:.5f} {color[0]} {color[1]} {color[2]}")
    for j in range(side - 1):
        for i in range(side - 1):
            a = j * side + i
            lines.append(f"3 {a} {a + 1} {a + side + 1}")
            lines.append(f"3 {a} {a + side + 1} {a + side}")
    path.write_text("\n".join(lines) + "\n")


def png(width, height, pixel):
    """A PNG of pixel(x, y) -> (r, g, b) or (r, g, b, a)."""
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))
    kind = 6 if len(pixel(0, 0)) == 4 else 2

    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    head = struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def write_crate(folder):
    """A textured OBJ: planks and a frame."""
    noise = random.Random(4)
    grain = [[noise.random() for _ in range(128)] for _ in range(128)]

    def wood(x, y):
        on_frame = min(x, y, 127 - x, 127 - y) < 14
        seam = not on_frame and y % 25 < 2
        shade = (0.75 if on_frame else 1.0) * (0.35 if seam else 1.0) * (0.85 + 0.15 * grain[y][x // 8])
        return [round(c * shade) for c in (196, 148, 92)]

    (folder / "crate.png").write_bytes(png(128, 128, wood))
    (folder / "crate.mtl").write_text("newmtl wood\nKd 1 1 1\nKs 0.05 0.05 0.05\nNs 20\nmap_Kd crate.png\n")
    lines = ["mtllib crate.mtl", "usemtl wood", "vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1"]
    faces = []
    for number, (low, high) in enumerate([((0, 0, 0), (1, 1, 1)), ((1.15, 0, 0.1), (2.15, 1, 1.1)),
                                          ((0.5, 1, 0.1), (1.5, 2, 1.1))]):
        x0, y0, z0 = low
        x1, y1, z1 = high
        lines += [f"v {x} {y} {z}" for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
        for quad in ((3, 1, 2, 4)[::-1], (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)):
            faces.append("f " + " ".join(f"{8 * number + v}/{k + 1}" for k, v in enumerate(quad)))
    (folder / "crate.obj").write_text("\n".join(lines + faces) + "\n")


def write_town(path):
    """A PLY of 150 boxes on a floor, z upwards."""
    dice = random.Random(11)
    triangles = box((-13, -13, -0.2), (13, 13, 0))
    for i in range(-6, 7):
        for j in range(-6, 7):
            if dice.random() < 0.12:
                continue
            x, y = 2 * i + dice.uniform(-0.2, 0.2), 2 * j + dice.uniform(-0.2, 0.2)
            w, d, h = dice.uniform(0.4, 0.75), dice.uniform(0.4, 0.75), dice.uniform(0.5, 4) ** 1.2
            triangles += box((x - w, y - d, 0), (x + w, y + d, h))
    points = [corner for triangle in triangles for corner in triangle]
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
            "property float x\nproperty float y\nproperty float z\n"
            f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
    body = b"".join(struct.pack("<3f", *p) for p in points)
    body += b"".join(struct.pack("<B3i", 3, 3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(triangles)))
    path.write_bytes(head.encode() + body)


class Gltf:
    """A glTF file whose data are in it."""

    def __init__(self):
        self.data = bytearray()
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                     "materials": [], "accessors": [], "bufferViews": [], "buffers": []}

    def accessor(self, rows, kind, component=5126):
        """Float rows, or uint32 scalars; returns the accessor's number."""
        code = {5126: "f", 5125: "I"}[component]
        flat = [value for row in rows for value in row]
        self.json["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(self.data), "byteLength": 4 * len(flat)})
        self.data += struct.pack(f"<{len(flat)}{code}", *flat)
        self.json["accessors"].append({
            "bufferView": len(self.json["bufferViews"]) - 1, "componentType": component, "type": kind,
            "count": len(rows), "min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]})
        return len(self.json["accessors"]) - 1

    def mesh(self, points, triangles, material, normals=None, uv=None):
        attributes = {"POSITION": self.accessor(points, "VEC3")}
        if normals:
            attributes["NORMAL"] = self.accessor(normals, "VEC3")
        if uv:
            attributes["TEXCOORD_0"] = self.accessor(uv, "VEC2")
        index = self.accessor([(k,) for t in triangles for k in t], "SCALAR", 5125)
        self.json["meshes"].append({"primitives": [{"attributes": attributes, "indices": index, "material": material}]})
        return len(self.json["meshes"]) - 1

    def material(self, name, color, metallic, roughness, **more):
        self.json["materials"].append({"name": name, "pbrMetallicRoughness": {
            "baseColorFactor": color, "metallicFactor": metallic, "roughnessFactor": roughness}, **more})
        return len(self.json["materials"]) - 1

    def node(self, **values):
        self.json["nodes"].append(values)
        number = len(self.json["nodes"]) - 1
        self.json["scenes"][0]["nodes"].append(number)
        return number

    def write(self, path):
        uri = "data:application/octet-stream;base64," + base64.b64encode(bytes(self.data)).decode()
        self.json["buffers"] = [{"byteLength": len(self.data), "uri": uri}]
        path.write_text(json.dumps(self.json))


def write_spheres(path):
    """Five spheres from rough to smooth, metals behind, plastics in front."""
    gltf = Gltf()
    points, normals, triangles = sphere(32, 64, 0.45)
    upright = [(x, z, -y) for x, y, z in points], [(x, z, -y) for x, y, z in normals]
    for row, (color, metallic) in enumerate([([0.9, 0.6, 0.25, 1], 1), ([0.15, 0.35, 0.8, 1], 0)]):
        for k in range(5):
            material = gltf.material(f"roughness {k / 4}", color, metallic, max(0.05, k / 4))
            mesh = gltf.mesh(upright[0], triangles, material, upright[1])
            gltf.node(mesh=mesh, translation=[k - 2, 0.5 - row, 0])
    gltf.write(path)


def write_leaves(path):
    """Forty leaves that are cut out of squares by a picture's alpha."""
    gltf = Gltf()

    def leaf(x, y):
        u, v = x / 63 * 2 - 1, y / 63 * 2 - 1
        inside = abs(u) < 0.75 * (1 - v * v) * (0.6 - 0.4 * v)
        vein = abs(u) < 0.04 or abs((v + abs(u)) % 0.3) < 0.03
        return [*([110, 160, 60] if vein else [60, 120, 40]), 255 if inside else 0]

    uri = "data:image/png;base64," + base64.b64encode(png(64, 64, leaf)).decode()
    gltf.json.update({"images": [{"uri": uri}], "samplers": [{}], "textures": [{"source": 0, "sampler": 0}]})
    material = gltf.material("leaf", [1, 1, 1, 1], 0, 0.7, alphaMode="MASK", alphaCutoff=0.5, doubleSided=True)
    gltf.json["materials"][material]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    square = [(-0.5, 0, 0), (0.5, 0, 0), (0.5, 1, 0), (-0.5, 1, 0)]
    mesh = gltf.mesh(square, [(0, 1, 2), (0, 2, 3)], material, [(0, 0, 1)] * 4, [(0, 1), (1, 1), (1, 0), (0, 0)])
    for k in range(40):
        around, lean = 2.399963 * k, 0.25 + k / 40
        turn = (0, math.sin(around / 2), 0, math.cos(around / 2))
        tilt = (math.sin(lean / 2), 0, 0, math.cos(lean / 2))
        rotation = [turn[3] * tilt[0], turn[1] * tilt[3], -turn[1] * tilt[0], turn[3] * tilt[3]]
        gltf.node(mesh=mesh, rotation=rotation, translation=[0, k * 0.02, 0])
    gltf.write(path)


def write_wheel(path):
    """A wheel of spokes that turns once in two seconds."""
    gltf = Gltf()
    steel = gltf.material("steel", [0.6, 0.62, 0.65, 1], 1, 0.35)
    rubber = gltf.material("rubber", [0.04, 0.04, 0.045, 1], 0, 0.9)
    points, normals, triangles = [], [], []
    sides, tube = 96, 24
    for i in range(sides):
        for j in range(tube):
            a, b = 2 * math.pi * i / sides, 2 * math.pi * j / tube
            n = (math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b))
            normals.append(n)
            points.append((math.cos(a) + 0.15 * n[0], math.sin(a) + 0.15 * n[1], 0.15 * n[2]))
            p, q = i * tube + j, i * tube + (j + 1) % tube
            r, s = (i + 1) % sides * tube + j, (i + 1) % sides * tube + (j + 1) % tube
            triangles += [(p, r, q), (q, r, s)]
    tyre = gltf.node(mesh=gltf.mesh(points, triangles, rubber, normals))
    spoke = box((-0.04, 0, -0.04), (0.04, 0.9, 0.04)) + box((-0.1, -0.1, -0.15), (0.1, 0.1, 0.15))
    corners = [corner for triangle in spoke for corner in triangle]
    mesh = gltf.mesh(corners, [(k, k + 1, k + 2) for k in range(0, len(corners), 3)], steel)
    spokes = [gltf.node(mesh=mesh, rotation=[0, 0, math.sin(math.pi * k / 8), math.cos(math.pi * k / 8)])
              for k in range(8)]
    wheel = gltf.node(name="wheel", children=[tyre, *spokes])
    gltf.json["scenes"][0]["nodes"] = [wheel]
    times = gltf.accessor([(t / 2,) for t in range(5)], "SCALAR")
    turns = gltf.accessor([(0, 0, math.sin(math.pi * t / 4), math.cos(math.pi * t / 4)) for t in range(5)], "VEC4")
    gltf.json["animations"] = [{"name": "turn", "samplers": [{"input": times, "output": turns}],
                                "channels": [{"sampler": 0, "target": {"node": wheel, "path": "rotation"}}]}]
    gltf.write(path)


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    write_stl(folder / "bracket.stl", bracket())
    points, _, triangles = sphere(11, 10)
    write_stl(folder / "ball.stl", [[points[k] for k in t] for t in triangles])
    write_heat(folder / "heat.ply")
    write_crate(folder)
    write_town(folder / "town.ply")
    write_spheres(folder / "spheres.gltf")
    write_leaves(folder / "leaves.gltf")
    write_wheel(folder / "wheel.gltf")
    return 0


if __name__ == "__main__":
    sys.exit(main())
