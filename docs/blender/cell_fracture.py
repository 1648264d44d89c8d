"""The table of docs/blender.md that compares with Cell Fracture:

    blender -b --factory-startup --python cell_fracture.py -- MESH.obj

Both break the same object, with every layer that a mesh can have, into about a hundred pieces, twice
with the same settings. The add-on is installed, or its folder is in PYTHONPATH.
"""

import hashlib
import math
import os
import sys
import time

import addon_utils
import bmesh
import bpy
import numpy as np

if not hasattr(bpy.types.Scene, "craze"):
    import craze_blender

    craze_blender.register()

PIECES = 100
THICKNESS = 0.02  # of the size


def dressed(path):
    """The mesh of the file as a new object, active, with all layers."""
    for data in (bpy.data.objects, bpy.data.materials):
        for old in list(data):
            data.remove(old)
    bpy.ops.wm.obj_import(filepath=path)
    thing = bpy.context.selected_objects[0]
    bpy.context.view_layer.objects.active = thing
    mesh = thing.data
    numbers = np.random.default_rng(1)
    for uv in list(mesh.uv_layers):
        mesh.uv_layers.remove(uv)
    mesh.materials.clear()
    for name in ("UVMap", "lightmap"):
        layer = mesh.uv_layers.new(name=name)
        layer.data.foreach_set("uv", numbers.uniform(0, 1, 2 * len(mesh.loops)).astype(np.float32))
    colour = mesh.color_attributes.new("paint", "BYTE_COLOR", "CORNER")
    colour.data.foreach_set("color", numbers.uniform(0, 1, 4 * len(mesh.loops)).astype(np.float32))
    wet = mesh.attributes.new("wet", "FLOAT", "POINT")
    wet.data.foreach_set("value", numbers.uniform(0, 1, len(mesh.vertices)).astype(np.float32))
    thing.vertex_groups.new(name="bone").add(range(len(mesh.vertices)), 0.5, "REPLACE")
    for name in ("glaze", "clay"):
        mesh.materials.append(bpy.data.materials.new(name))
    for edge in mesh.edges:
        edge.use_seam = edge.use_edge_sharp = edge.index % 7 == 0
        edge.crease = 0.5 if edge.index % 5 == 0 else 0.0
    thing.shape_key_add(name="Basis")
    thing.shape_key_add(name="smile", from_mix=False)
    return thing


LAYERS = {
    "UV maps": lambda o: len(o.data.uv_layers) == 2,
    "colours": lambda o: "paint" in o.data.color_attributes,
    "materials": lambda o: {"glaze", "clay"} <= {m.name for m in o.data.materials if m},
    "weights": lambda o: "bone" in o.vertex_groups and any(v.groups for v in o.data.vertices),
    "custom attributes": lambda o: "wet" in o.data.attributes,
    "seams": lambda o: any(e.use_seam for e in o.data.edges),
    "sharp edges": lambda o: any(e.use_edge_sharp for e in o.data.edges),
    "creases": lambda o: any(e.crease > 0 for e in o.data.edges),
    "shape keys": lambda o: o.data.shape_keys is not None,
}


def kept(pieces):
    """Layers that nearly every piece has: one of a few edges may have no seam."""
    return [name for name, has in LAYERS.items() if sum(map(has, pieces)) > 0.9 * len(pieces)]


def solid(thing):
    """The piece with its modifiers, as a bmesh; None: it is not closed, not even with vertices in one
    place as one, which Cell Fracture parts along sharp edges."""
    shape = bmesh.new()
    shape.from_object(thing, bpy.context.evaluated_depsgraph_get())
    for merge in (False, True):
        if merge:
            bmesh.ops.remove_doubles(shape, verts=shape.verts, dist=1e-6 * max(thing.dimensions))
        if all(e.is_manifold for e in shape.edges):
            return shape
    shape.free()
    return None


def hull_of(shape):
    """Volume of the convex hull of a bmesh."""
    hull = bmesh.new()
    for vertex in shape.verts:
        hull.verts.new(vertex.co)
    made = bmesh.ops.convex_hull(hull, input=hull.verts)
    bmesh.ops.delete(hull, geom=made["geom_interior"], context="VERTS")
    volume = abs(hull.calc_volume())
    hull.free()
    return volume


def measured(pieces):
    """Share that is closed; and volume over that of the convex hull, in the mean of those."""
    filled = []
    for thing in pieces:
        shape = solid(thing)
        if shape is not None:
            filled.append(abs(shape.calc_volume()) / hull_of(shape))
            shape.free()
    return len(filled) / len(pieces), float(np.mean(filled)) if filled else math.nan


def digest(pieces):
    """Of the vertices of all pieces, in whatever order they are."""
    each = []
    for thing in pieces:
        co = np.empty(3 * len(thing.data.vertices), np.float32)
        thing.data.vertices.foreach_get("co", co)
        each.append(hashlib.sha256(co.tobytes()).hexdigest())
    return hashlib.sha256("".join(sorted(each)).encode()).hexdigest()


def cell_fracture(thing):
    addon_utils.enable("object_fracture_cell")
    before = set(bpy.data.objects)
    bpy.ops.object.add_fracture_cell_objects(
        source={"VERT_OWN"}, source_limit=PIECES, use_debug_redraw=False, use_remove_original=False
    )
    return [o for o in bpy.data.objects if o not in before]


def craze(thing):
    before = set(bpy.data.objects)
    area = sum(p.area for p in thing.data.polygons)
    bpy.ops.craze.crack(preset="mud", seed=1, spacing=math.sqrt(area / PIECES))
    bpy.ops.craze.pieces(thickness=THICKNESS * max(thing.dimensions))
    return [o for o in bpy.data.objects if o not in before and " fragment " in o.name]


def used():
    """Seconds of processors so far, the engine's too where it has ended."""
    t = os.times()
    return t.user + t.system + t.children_user + t.children_system


def row(name, tool, path):
    found = []
    for _ in range(2):
        thing = dressed(path)
        wall, cpu = time.perf_counter(), used()
        pieces = tool(thing)
        wall = time.perf_counter() - wall
        if name == "craze":
            craze_blender.process.stop()
        found.append((wall, used() - cpu, digest(pieces)))
        print(f"{name}: {len(pieces)} pieces in {wall:.1f} s, {found[-1][1]:.1f} s of processors")
    closed, filled = measured(pieces)
    same = "same bytes" if found[0][2] == found[1][2] else "other pieces"
    layers = ", ".join(kept(pieces)) or "none"
    print(f"| {name} | {len(pieces)} | {min(f[0] for f in found):.1f} s "
          f"({min(f[1] for f in found):.1f} s) | {same} | {closed:.0%} | {filled:.2f} | {layers} |")  # fmt: skip


if __name__ == "__main__":
    file = os.path.abspath(sys.argv[sys.argv.index("--") + 1])
    for title, function in (("craze", craze), ("Cell Fracture", cell_fracture)):
        row(title, function, file)
