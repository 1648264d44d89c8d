"""A scene with a bit of everything that cracks must leave alone: truck.py FILE.glb

A turned node with a textured, flat shaded body and a smooth tank below it; a mast that joints bend,
animated; a flag with a morph target, animated; glass that lets light through; a camera and a light.
Needs the standard library alone.
"""

import json
import math
import struct
import sys
import zlib

FLOAT, USHORT, UBYTE, UINT = 5126, 5123, 5121, 5125
SHAPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class Document:
    def __init__(self):
        self.bytes = bytearray()
        self.views, self.accessors = [], []

    def view(self, data, **more):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data), **more})
        self.bytes += data
        return len(self.views) - 1

    def add(self, rows, kind=FLOAT, bounded=False, **more):
        rows = [row if isinstance(row, (list, tuple)) else (row,) for row in rows]
        code = {FLOAT: "f", USHORT: "H", UBYTE: "B", UINT: "I"}[kind]
        flat = [x for row in rows for x in row]
        accessor = {
            "bufferView": self.view(struct.pack(f"<{len(flat)}{code}", *flat), **more),
            "componentType": kind, "count": len(rows), "type": SHAPES[len(rows[0])],
        }
        if bounded:
            single = [struct.unpack("<f", struct.pack("<f", x))[0] for x in flat]
            n = len(rows[0])
            accessor["min"] = [min(single[k::n]) for k in range(n)]
            accessor["max"] = [max(single[k::n]) for k in range(n)]
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def primitive(self, points, normals, uvs, triangles, material, **more):
        place = {"target": 34962}
        attributes = {
            "POSITION": self.add(points, bounded=True, **place),
            "NORMAL": self.add(normals, **place),
            "TEXCOORD_0": self.add(uvs, **place),
        }
        for name, (rows, kind) in more.items():
            attributes[name] = self.add(rows, kind, **place)
        corners = [i for t in triangles for i in t]
        return {"attributes": attributes, "material": material,
                "indices": self.add(corners, USHORT, target=34963)}

    def save(self, path, root):
        root.update(bufferViews=self.views, accessors=self.accessors,
                    buffers=[{"byteLength": len(self.bytes)}])
        text = json.dumps(root).encode()
        text += b" " * (-len(text) % 4)
        data = bytes(self.bytes) + b"\0" * (-len(self.bytes) % 4)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)))
            file.write(struct.pack("<I4s", len(text), b"JSON") + text)
            file.write(struct.pack("<I4s", len(data), b"BIN\0") + data)


def png(size, pixel):
    """A picture of pixel(x, y) -> (r, g, b)."""
    rows = b"".join(b"\0" + bytes(c for x in range(size) for c in pixel(x, y)) for y in range(size))

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def box(size):
    """Twelve triangles, flat."""
    points, normals, uvs, triangles = [], [], [], []
    for axis in range(3):
        for sign in (-1, 1):
            a, b = (axis + 1) % 3, (axis + 2) % 3
            first = len(points)
            for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                p, n = [0.0] * 3, [0.0] * 3
                p[axis], p[a], p[b] = sign * size[axis], (2 * u - 1) * size[a], (2 * v - 1) * size[b]
                n[axis] = float(sign)
                points.append(p)
                normals.append(n)
                uvs.append((u, v))
            order = ((0, 1, 2), (0, 2, 3)) if sign > 0 else ((0, 2, 1), (0, 3, 2))
            triangles += [[first + i for i in t] for t in order]
    return points, normals, uvs, triangles


def grid(columns, rows, point, normal):
    """A patch of point(u, v), smooth."""
    points, normals, uvs, triangles = [], [], [], []
    for j in range(rows + 1):
        for i in range(columns + 1):
            u, v = i / columns, j / rows
            points.append(point(u, v))
            normals.append(normal(u, v))
            uvs.append((u, 1 - v))
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            triangles += [(a, b, c), (a, c, d)]
    return points, normals, uvs, triangles


def round_wall(radius, height):
    def normal(u, v):
        return (math.cos(2 * math.pi * u), 0.0, -math.sin(2 * math.pi * u))

    def point(u, v):
        x, _, z = normal(u, v)
        return (radius * x, height * v, radius * z)

    return point, normal


def truck(path):
    made = Document()
    picture = png(64, lambda x, y: (200, 60 + 2 * x, 40) if (x // 8 + y // 8) % 2 else (240, 220, 3 * y))
    body = made.primitive(*box((1.0, 0.5, 0.6)), 0)
    tank = made.primitive(*grid(24, 6, *round_wall(0.35, 0.8)), 1)
    sheet = grid(12, 8, lambda u, v: (0.8 * u, 0.5 * v, 0.0), lambda u, v: (0.0, 0.0, 1.0))
    flag = made.primitive(*sheet, 2)
    wave = [(0.0, 0.0, 0.15 * math.sin(3 * p[0])) for p in sheet[0]]
    flag["targets"] = [{"POSITION": made.add(wave, bounded=True, target=34962)}]
    pole = grid(16, 24, *round_wall(0.12, 1.6))
    bend = [min(max((p[1] - 0.4) / 0.8, 0.0), 1.0) for p in pole[0]]
    mast = made.primitive(
        *pole, 1,
        JOINTS_0=([(0, 1 if w > 0 else 0, 0, 0) for w in bend], UBYTE),
        WEIGHTS_0=([(1 - w, w, 0.0, 0.0) for w in bend], FLOAT))
    window = made.primitive(
        *grid(6, 6, lambda u, v: (0.6 * u, 0.5 * v, 0.0), lambda u, v: (0.0, 0.0, 1.0)), 3)
    still = [1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0]
    up = still[:12] + [0.0, -0.8, 0.0, 1.0]
    half = math.sin(math.pi / 8), math.cos(math.pi / 8)
    times = made.add([0.0, 0.5, 1.0], bounded=True)
    sway = made.add([(0.0, 0.0, 0.0, 1.0), (0.0, 0.0, half[0], half[1]), (0.0, 0.0, 0.0, 1.0)])
    waves = made.add([0.0, 1.0, 0.0])
    root = {
        "asset": {"version": "2.0"}, "scene": 0,
        "scenes": [{"name": "yard", "nodes": [0, 6, 7, 8, 9]}],
        "nodes": [
            {"name": "truck", "children": [1, 2, 3, 4], "translation": [0.3, 0.5, 0.0],
             "rotation": [0.0, math.sin(0.2), 0.0, math.cos(0.2)]},
            {"name": "body", "mesh": 0},
            {"name": "tank", "mesh": 1, "translation": [0.2, 0.52, 0.0], "scale": [1.0, 0.9, 1.0]},
            {"name": "flag", "mesh": 2, "translation": [-0.9, 0.8, 0.3]},
            {"name": "window", "mesh": 4, "translation": [-0.8, 0.0, 0.62]},
            {"name": "mast top", "translation": [0.0, 0.8, 0.0]},
            {"name": "mast", "mesh": 3, "skin": 0},
            {"name": "mast foot", "children": [5], "translation": [1.9, 0.0, 0.0]},
            {"name": "view", "camera": 0, "translation": [0.6, 1.0, 5.0]},
            {"name": "sun", "extensions": {"KHR_lights_punctual": {"light": 0}},
             "rotation": [-0.35, 0.2, 0.0, math.sqrt(1 - 0.35**2 - 0.2**2)]},
        ],
        "meshes": [
            {"name": "body", "primitives": [body]},
            {"name": "tank", "primitives": [tank]},
            {"name": "flag", "primitives": [flag], "weights": [0.25],
             "extras": {"targetNames": ["wind"]}},
            {"name": "mast", "primitives": [mast]},
            {"name": "window", "primitives": [window]},
        ],
        "skins": [{"name": "mast", "joints": [7, 5], "inverseBindMatrices": made.add([still, up])}],
        "animations": [
            {"name": "sway", "channels": [{"sampler": 0, "target": {"node": 5, "path": "rotation"}}],
             "samplers": [{"input": times, "output": sway}]},
            {"name": "wave", "channels": [{"sampler": 0, "target": {"node": 3, "path": "weights"}}],
             "samplers": [{"input": times, "output": waves}]},
        ],
        "materials": [
            {"name": "paint", "pbrMetallicRoughness": {
                "baseColorTexture": {"index": 0}, "metallicFactor": 0.0, "roughnessFactor": 0.6}},
            {"name": "steel", "pbrMetallicRoughness": {
                "baseColorFactor": [0.5, 0.55, 0.6, 1.0], "metallicFactor": 0.0,
                "roughnessFactor": 0.5}},
            {"name": "cloth", "doubleSided": True, "pbrMetallicRoughness": {
                "baseColorTexture": {"index": 0, "extensions": {
                    "KHR_texture_transform": {"scale": [0.5, 0.5], "offset": [0.25, 0.0]}}},
                "metallicFactor": 0.0, "roughnessFactor": 0.9}},
            {"name": "glass", "alphaMode": "BLEND", "pbrMetallicRoughness": {
                "baseColorFactor": [0.6, 0.8, 0.9, 0.4], "metallicFactor": 0.0,
                "roughnessFactor": 0.2}},
        ],
        "textures": [{"name": "checks", "source": 0, "sampler": 0}],
        "samplers": [{"magFilter": 9729, "minFilter": 9987}],
        "images": [{"name": "checks", "mimeType": "image/png", "bufferView": made.view(picture)}],
        "cameras": [{"name": "view", "type": "perspective",
                     "perspective": {"yfov": 0.7, "znear": 0.1, "aspectRatio": 1.5}}],
        "extensionsUsed": ["KHR_lights_punctual", "KHR_texture_transform"],
        "extensions": {"KHR_lights_punctual": {"lights": [
            {"name": "sun", "type": "directional", "intensity": 3.0}]}},
    }
    made.save(path, root)


if __name__ == "__main__":
    truck(sys.argv[1])
