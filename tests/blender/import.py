"""Blender headless, as a reader of what craze writes: blender -b -P import.py -- FOLDER"""
import pathlib
import sys

import bpy
import numpy

numpy.bool = bool  # Debian's Blender 3.4 asks for a name that Debian's NumPy no longer has
folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])


def load(name):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    path = str(folder / name)
    if name.endswith(".glb"):
        bpy.ops.import_scene.gltf(filepath=path)
    elif name.endswith(".obj"):
        bpy.ops.wm.obj_import(filepath=path)
    else:
        bpy.ops.import_mesh.ply(filepath=path)
    return [o for o in bpy.data.objects if o.type == "MESH"]


def shape_at(thing, frame):
    bpy.context.scene.frame_set(frame)
    mesh = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    return [tuple(v.co) for v in mesh.vertices]


[whole] = load("open.glb")
materials = [m.name for m in whole.data.materials]
assert materials == ["surface", "crack_wall"], materials
assert len(whole.data.uv_layers) == 1
triangles = len(whole.data.polygons)
assert triangles == len(load("open.ply")[0].data.polygons)

[growing] = load("growing.glb")
assert len(growing.data.polygons) == triangles
assert len(growing.data.shape_keys.key_blocks) == 1 + 12
assert growing.data.shape_keys.animation_data.action.name.startswith("growth")
shapes = [shape_at(growing, frame) for frame in (0, 30, 60, 200)]
assert len(set(map(len, shapes))) == 1
assert all(a != b for a, b in zip(shapes, shapes[1:])), "nothing moves"

names = sorted(o.name for o in load("pieces.obj"))
pieces = load("pieces.glb")
assert len(pieces) > 3 and sorted(o.name for o in pieces) == names
for piece in pieces:
    low = [min(v.co[k] for v in piece.data.vertices) for k in range(3)]
    high = [max(v.co[k] for v in piece.data.vertices) for k in range(3)]
    assert all(a <= 0 <= b for a, b in zip(low, high)), "the origin is not in the piece"
print("blender: all is well")
