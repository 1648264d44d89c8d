#!/usr/bin/env python3
"""Assets before and after they crack: docs/images/kept.

usage: kept_assets.py CRAZE OUT_FOLDER

Writes the assets, NAME.glb, and the cracked ones to OUT_FOLDER/work, pictures of both to OUT_FOLDER.
"""

import math
import pathlib
import random
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "tests" / "gltf"))
from truck import Document, box, png  # noqa: E402

SHOT = ["--width", "400", "--height", "300", "--samples", "32", "--quiet"]


def flat(polygons):
    """Convex polygons as triangles with a normal each."""
    points, normals, uvs, triangles = [], [], [], []
    for polygon in polygons:
        a, b, c = polygon[:3]
        u, v = [[q[k] - a[k] for k in range(3)] for q in (b, c)]
        n = [u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3] for k in range(3)]
        length = math.sqrt(sum(x * x for x in n))
        first = len(points)
        for corner, p in enumerate(polygon):
            points.append(p)
            normals.append([x / length for x in n])
            uvs.append(((corner + 1) // 2 % 2, corner // 2))
        triangles += [(first, first + i, first + i + 1) for i in range(1, len(polygon) - 1)]
    return points, normals, uvs, triangles


def bevelled(size, bevel):
    """A box with its edges cut off: 26 faces."""
    def corner(signs, long):
        return tuple(s * (size[k] if k == long else size[k] - bevel) for k, s in enumerate(signs))

    def outward(polygon):
        a, b, c = polygon[:3]
        u, v = [[q[k] - a[k] for k in range(3)] for q in (b, c)]
        n = [u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3] for k in range(3)]
        return polygon if sum(x * y for x, y in zip(n, a)) > 0 else polygon[::-1]

    faces = []
    around = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        def at(s, t, u):
            signs = [0, 0, 0]
            signs[axis], signs[b], signs[c] = s, t, u
            return signs
        for s in (-1, 1):
            faces.append([corner(at(s, t, u), axis) for t, u in around])
        for t, u in around:
            faces.append([corner(at(-1, t, u), b), corner(at(1, t, u), b),
                          corner(at(1, t, u), c), corner(at(-1, t, u), c)])
    for x in (-1, 1):
        for y in (-1, 1):
            for z in (-1, 1):
                faces.append([corner((x, y, z), k) for k in range(3)])
    return flat([outward(face) for face in faces])


def lathe(profile, sides):
    """A jug of few flat faces, its texture once around."""
    points, normals, uvs, triangles = [], [], [], []
    for (r0, y0, v0), (r1, y1, v1) in zip(profile, profile[1:]):
        for i in range(sides):
            a, b = (2 * math.pi * k / sides for k in (i, i + 1))
            quad = [(r * math.cos(t), y, -r * math.sin(t))
                    for r, y, t in ((r0, y0, a), (r0, y0, b), (r1, y1, b), (r1, y1, a))]
            p, n, _, t = flat([quad])
            first = len(points)
            points += p
            normals += n
            uvs += [(i / sides, v0), ((i + 1) / sides, v0), ((i + 1) / sides, v1), (i / sides, v1)]
            triangles += [[first + k for k in corner] for corner in t]
    return points, normals, uvs, triangles


def material(name, color, **more):
    return {"name": name, "pbrMetallicRoughness": {
        "baseColorFactor": [*color, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.5}, **more}


def save(path, parts, materials, picture=None):
    """parts: (name, mesh, material, translation)."""
    made = Document()
    root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(parts)))}],
            "nodes": [{"name": name, "mesh": i, "translation": place}
                      for i, (name, _, _, place) in enumerate(parts)],
            "meshes": [{"name": name, "primitives": [made.primitive(*mesh, of)]}
                       for name, mesh, of, _ in parts],
            "materials": materials}
    if picture:
        root["images"] = [{"mimeType": "image/png", "bufferView": made.view(picture)}]
        root["textures"] = [{"source": 0}]
        materials[0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    made.save(path, root)


def cube(path):
    save(path, [("cube", bevelled((1.0, 1.0, 1.0), 0.12), 0, [0, 0, 0])],
         [material("stone", (0.75, 0.55, 0.35))])


def jug(path):
    profile = [(0.35, 0.0, 1.0), (0.62, 0.35, 0.75), (0.66, 0.7, 0.5), (0.4, 1.15, 0.25), (0.48, 1.4, 0.0)]

    def pixel(x, y):
        if y // 8 in (3, 4):
            return (230, 225, 210) if (x // 8 + y // 8) % 2 else (30, 60, 120)
        return (180, 80, 50) if y // 8 in (2, 5) else (225, 205, 165)

    save(path, [("jug", lathe(profile, 14), 0, [0, 0, 0])], [material("painted", (1, 1, 1),
         doubleSided=True)], png(64, pixel))


def car(path):
    wheel = lathe([(0.05, -0.1, 0), (0.3, -0.1, 0.3), (0.3, 0.1, 0.7), (0.05, 0.1, 1)], 16)
    wheel = ([(x, z, -y) for x, y, z in wheel[0]], [(x, z, -y) for x, y, z in wheel[1]], *wheel[2:])
    parts = [("body", bevelled((1.6, 0.32, 0.7), 0.1), 0, [0, 0.55, 0]),
             ("roof", bevelled((0.72, 0.06, 0.6), 0.05), 0, [-0.1, 1.42, 0])]
    for side in (-1, 1):
        for x in (-0.76, -0.1, 0.56):
            parts.append(("pillar", box((0.04, 0.26, 0.04)), 0, [x, 1.13, 0.54 * side]))
        for x in (-0.95, 0.95):
            parts.append(("wheel", wheel, 2, [x, 0.3, 0.66 * side]))
        for x in (-0.45, 0.15):
            parts.append(("seat", box((0.17, 0.06, 0.2)), 3, [x, 0.93, 0.27 * side]))
            parts.append(("back", box((0.04, 0.2, 0.2)), 3, [x - 0.2, 1.1, 0.27 * side]))
        pane = [(-0.76, 0.87, 0.54), (0.56, 0.87, 0.54), (0.56, 1.37, 0.54), (-0.76, 1.37, 0.54)]
        parts.append(("side window", flat([[(x, y, z * side) for x, y, z in pane]]), 1, [0, 0, 0]))
    for x in (-0.76, 0.56):
        pane = [(x, 0.87, -0.54), (x, 0.87, 0.54), (x, 1.37, 0.54), (x, 1.37, -0.54)]
        parts.append(("screen", flat([pane]), 1, [0, 0, 0]))
    glass = material("glass", (0.45, 0.7, 0.75), alphaMode="BLEND", doubleSided=True)
    glass["pbrMetallicRoughness"]["baseColorFactor"][3] = 0.3
    save(path, parts, [material("paint", (0.6, 0.06, 0.05)), glass,
                       material("rubber", (0.03, 0.03, 0.03)), material("leather", (0.7, 0.45, 0.2))])


def scan(path):
    """A head of clay as a scanner sees it: 80,000 triangles, rough, open below, with ears and a nose."""
    rows, columns = 160, 250
    dice = random.Random(1)

    def point(i, j):
        t, a = math.pi * (0.02 + 0.86 * i / rows), 2 * math.pi * j / columns
        n = (math.sin(t) * math.cos(a), math.cos(t), math.sin(t) * math.sin(a))
        r = 0.8 + 0.08 * math.sin(3 * n[1] + 1) + 0.03 * math.sin(5 * n[0]) * math.cos(4 * n[2])
        for place, high, wide in (((0, -0.05, 1), 0.22, 0.16), ((0.97, 0, 0.2), 0.2, 0.2),
                                  ((-0.97, 0, 0.2), 0.2, 0.2), ((0.35, 0.25, 0.9), -0.07, 0.16),
                                  ((-0.35, 0.25, 0.9), -0.07, 0.16), ((0, -0.45, 0.9), 0.06, 0.2)):
            length = math.sqrt(sum(x * x for x in place))
            far = sum((x - y / length) ** 2 for x, y in zip(n, place))
            r += high * math.exp(-far / wide**2)
        r += dice.gauss(0, 0.0025)
        return (r * n[0], 1.2 * r * n[1], r * n[2])

    grid = [point(i, j) for i in range(rows + 1) for j in range(columns)]
    faces = []
    for i in range(rows):
        for j in range(columns):
            a, b = i * columns + j, i * columns + (j + 1) % columns
            faces += [(a, b, b + columns), (a, b + columns, a + columns)]
    with open(path, "w") as file:
        file.write(f"ply\nformat ascii 1.0\nelement vertex {len(grid)}\n")
        file.write("".join(f"property float {k}\n" for k in "xyz"))
        file.write(f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
        file.writelines("%.6f %.6f %.6f\n" % p for p in grid)
        file.writelines("3 %d %d %d\n" % f for f in faces)


ASSETS = [
    (cube, ["--preset", "glaze", "--set", "layer.relative_spacing=0.09"], ["--azimuth", "35"]),
    (jug, ["--preset", "glaze", "--set", "layer.relative_spacing=0.07"], []),
    (car, ["--preset", "paint", "--set", "layer.relative_spacing=0.05", "--set",
           'where.materials=["paint"]', "--set", "picture.material=glaze"],
     ["--azimuth", "30"]),
    (scan, ["--preset", "glaze", "--set", "layer.relative_spacing=0.06", "--set",
            "picture.material=clay"], ["--azimuth", "20", "--elevation", "12", "--up", "y"]),
]


def main():
    craze, out = sys.argv[1], pathlib.Path(sys.argv[2])
    work = out / "work"
    work.mkdir(parents=True, exist_ok=True)
    for make, recipe, view in ASSETS:
        kind = "ply" if make is scan else "glb"
        given, cracked = (work / f"{make.__name__}{cut}.{kind}" for cut in ("", "_cracked"))
        make(given)
        run = ["crack", given, *recipe, "-o", cracked, *SHOT, *view]
        for when, stop in (("before", ["--max-cracks", "0"]), ("after", [])):
            picture = out / f"{make.__name__}_{when}.png"
            subprocess.run([craze, *run, *stop, "--picture", picture], check=True)


if __name__ == "__main__":
    main()
