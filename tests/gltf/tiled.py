"""A scene whose UVs are no place for maps: tiled.py FILE.glb

Brick that repeats, on a box with tangents, on a mast that a joint bends and on a mesh of another scene; a
column that two nodes show and tiles that are instances; a banner with a morph target, its halves
mirrored onto each other, with occlusion in a second UV set; an urn without UVs; glass. Needs the standard
library alone.
"""

import math
import sys

from truck import FLOAT, UBYTE, Document, box, grid, png, round_wall


def brick(x, y):
    row = y // 16
    if y % 16 < 2 or (x + 16 * (row % 2)) % 32 < 2:
        return (150, 145, 135)
    return (170 - 9 * (row % 3), 80 + 7 * ((x + 16 * (row % 2)) // 32 % 2), 60)


def bumps(x, y):
    """Joints that lie deeper: leans left and right of them, and above and below, green up."""
    row, across = y // 16, (x + 16 * (y // 16 % 2)) % 32
    red = 90 if across == 31 else 166 if across == 2 else 128
    green = 166 if y % 16 == 15 else 90 if y % 16 == 2 else 128
    return (red, green, 255)


def stripes(x, y):
    return (60, 90, 160) if (x // 6) % 2 else (225, 215, 190)


def shade(x, y):
    return (160 + x, 160 + x, 160 + x)


def scaled(parts, u, v):
    points, normals, uvs, triangles = parts
    return points, normals, [(u * a, v * b) for a, b in uvs], triangles


def tiled(path):
    made = Document()
    pictures = [png(64, p) for p in (brick, bumps, stripes, shade)]
    walls = scaled(box((1.0, 0.6, 0.4)), 4, 3)
    along = []
    for n in walls[1]:
        axis = max(range(3), key=lambda k: abs(n[k]))
        along.append(tuple(1.0 if k == (axis + 1) % 3 else 0.0 for k in range(3)) + (sum(n),))
    wall = made.primitive(*walls, 0, TANGENT=(along, FLOAT))
    column = made.primitive(*grid(20, 5, *round_wall(0.15, 1.0)), 1)
    pole = scaled(grid(16, 16, *round_wall(0.12, 1.4)), 2, 4)
    bend = [min(max((p[1] - 0.4) / 0.6, 0.0), 1.0) for p in pole[0]]
    mast = made.primitive(
        *pole, 0,
        JOINTS_0=([(0, 1 if w > 0 else 0, 0, 0) for w in bend], UBYTE),
        WEIGHTS_0=([(1 - w, w, 0.0, 0.0) for w in bend], FLOAT))
    sheet = grid(12, 8, lambda u, v: (1.2 * u, 0.6 * v, 0.0), lambda u, v: (0.0, 0.0, 1.0))
    mirrored = [(2 * u if u <= 0.5 else 2 - 2 * u, v) for u, v in sheet[2]]
    banner = made.primitive(sheet[0], sheet[1], mirrored, sheet[3], 2, TEXCOORD_1=(sheet[2], FLOAT))
    wave = [(0.0, 0.0, 0.15 * math.sin(3 * p[0])) for p in sheet[0]]
    banner["targets"] = [{"POSITION": made.add(wave, bounded=True, target=34962)}]
    urn = made.primitive(*grid(24, 10, lambda u, v: tuple(
        (0.25 + 0.12 * math.sin(3 * v)) * c if k != 1 else 0.7 * v
        for k, c in enumerate((math.cos(2 * math.pi * u), 0, -math.sin(2 * math.pi * u)))),
        round_wall(1, 1)[1]), 3)
    del urn["attributes"]["TEXCOORD_0"]
    tile = made.primitive(*box((0.2, 0.03, 0.2)), 4)
    window = made.primitive(
        *grid(4, 4, lambda u, v: (0.5 * u, 0.5 * v, 0.0), lambda u, v: (0.0, 0.0, 1.0)), 5)
    del window["attributes"]["TEXCOORD_0"]
    spare = made.primitive(*scaled(box((0.1, 0.1, 0.1)), 2, 2), 0)
    still = [1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0]
    up = still[:12] + [0.0, -0.7, 0.0, 1.0]
    half = math.sin(math.pi / 8), math.cos(math.pi / 8)
    times = made.add([0.0, 0.5, 1.0], bounded=True)
    sway = made.add([(0.0, 0.0, 0.0, 1.0), (0.0, 0.0, half[0], half[1]), (0.0, 0.0, 0.0, 1.0)])
    places = made.add([(-0.9, 0.03, 1.0), (-0.3, 0.03, 1.0), (0.3, 0.03, 1.0)])
    views = [made.view(p) for p in pictures]

    def surface(base, roughness, **more):
        return {"pbrMetallicRoughness": {"metallicFactor": 0.0, "roughnessFactor": roughness, **base}, **more}

    root = {
        "asset": {"version": "2.0"}, "scene": 0,
        "scenes": [{"name": "yard", "nodes": [0, 1, 2, 3, 4, 5, 6, 7, 9]}, {"name": "store", "nodes": [10]}],
        "nodes": [
            {"name": "wall", "mesh": 0, "translation": [0.0, 0.6, 0.0]},
            {"name": "left column", "mesh": 1, "translation": [-1.3, 0.0, 0.3]},
            {"name": "right column", "mesh": 1, "translation": [1.3, 0.0, 0.3]},
            {"name": "mast", "mesh": 2, "skin": 0},
            {"name": "banner", "mesh": 3, "translation": [-0.6, 1.35, 0.0]},
            {"name": "urn", "mesh": 4, "translation": [0.9, 0.0, 1.0]},
            {"name": "tiles", "mesh": 5,
             "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places}}}},
            {"name": "mast foot", "children": [8], "translation": [1.9, 0.0, 0.0]},
            {"name": "mast top", "translation": [0.0, 0.7, 0.0]},
            {"name": "window", "mesh": 6, "translation": [-2.2, 0.4, 0.4]},
            {"name": "spare", "mesh": 7},
        ],
        "meshes": [{"name": name, "primitives": [p]} for name, p in (
            ("wall", wall), ("column", column), ("mast", mast), ("banner", banner), ("urn", urn),
            ("tile", tile), ("window", window), ("spare", spare))],
        "skins": [{"name": "mast", "joints": [7, 8], "inverseBindMatrices": made.add([still, up])}],
        "animations": [
            {"name": "sway", "channels": [{"sampler": 0, "target": {"node": 8, "path": "rotation"}}],
             "samplers": [{"input": times, "output": sway}]}],
        "materials": [
            surface({"baseColorTexture": {"index": 0}}, 0.8, name="brick",
                    normalTexture={"index": 1, "scale": 0.8}, emissiveTexture={"index": 0},
                    emissiveFactor=[0.05, 0.05, 0.05]),
            surface({"baseColorTexture": {"index": 2}}, 0.6, name="plaster"),
            surface({"baseColorTexture": {"index": 2}}, 0.9, name="cloth", doubleSided=True,
                    occlusionTexture={"index": 3, "texCoord": 1}),
            surface({"baseColorFactor": [0.7, 0.45, 0.3, 1.0]}, 0.7, name="clay", doubleSided=True),
            surface({"baseColorFactor": [0.6, 0.65, 0.6, 1.0]}, 0.4, name="tile"),
            surface({"baseColorFactor": [0.6, 0.8, 0.9, 0.4]}, 0.1, name="glass", alphaMode="BLEND"),
        ],
        "textures": [{"source": i, "sampler": 0} for i in range(4)],
        "samplers": [{"magFilter": 9729, "minFilter": 9987}],
        "images": [{"name": name, "mimeType": "image/png", "bufferView": view}
                   for name, view in zip(("brick", "bumps", "stripes", "shade"), views)],
        "extensionsUsed": ["EXT_mesh_gpu_instancing"],
    }
    root["meshes"][3]["weights"] = [0.25]
    made.save(path, root)


if __name__ == "__main__":
    tiled(sys.argv[1])
