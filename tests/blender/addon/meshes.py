"""Random meshes with every layer that a Blender mesh can have, and an empty scene to put them in."""

import random

import bmesh
import bpy
import numpy as np


def empty():
    """Takes everything out of the file."""
    for data in (bpy.data.objects, bpy.data.meshes, bpy.data.materials, bpy.data.curves,
                 bpy.data.armatures, bpy.data.actions, bpy.data.texts, bpy.data.images,
                 bpy.data.node_groups, bpy.data.cameras):  # fmt: skip
        for item in list(data):
            data.remove(item)
    for collection in list(bpy.data.collections):
        bpy.data.collections.remove(collection)


def link(mesh, name="thing"):
    """A new object, active and selected alone."""
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    activate(thing)
    return thing


def activate(thing):
    for other in bpy.context.selected_objects:
        other.select_set(False)
    thing.hide_set(False)
    thing.select_set(True)
    bpy.context.view_layer.objects.active = thing


def grid(n=12, name="grid", size=1.0):
    """n × n squares, with UVs in one piece."""
    mesh = bpy.data.meshes.new(name)
    shape = bmesh.new()
    bmesh.ops.create_grid(shape, x_segments=n, y_segments=n, size=size)
    shape.to_mesh(mesh)
    shape.free()
    uv = mesh.uv_layers.new(name="UVMap").data
    for loop in mesh.loops:
        uv[loop.index].uv = mesh.vertices[loop.vertex_index].co.xy / (2 * size)
    return mesh


def random_shape(rng):
    """Triangles, quads and larger polygons, open or closed, no two vertices in one place."""
    shape = bmesh.new()
    kind = rng.choice(["grid", "ball", "cube", "cone"])
    if kind == "grid":
        n = rng.randint(5, 14)
        bmesh.ops.create_grid(shape, x_segments=n, y_segments=rng.randint(5, 14), size=1.0)
    elif kind == "ball":
        bmesh.ops.create_icosphere(shape, subdivisions=3, radius=1.0)
    elif kind == "cube":
        bmesh.ops.create_cube(shape, size=2.0)
        bmesh.ops.subdivide_edges(
            shape, edges=shape.edges, cuts=rng.randint(3, 7), use_grid_fill=True
        )
    else:
        bmesh.ops.create_cone(
            shape, segments=rng.randint(9, 24), radius1=1.0, radius2=0.5, depth=1.5, cap_ends=True
        )
    if kind in {"grid", "cube"} and rng.random() < 0.6:
        # Larger polygons: some edges taken out.
        edges = [e for e in shape.edges if len(e.link_faces) == 2 and rng.random() < 0.05]
        bmesh.ops.dissolve_edges(shape, edges=edges, use_verts=False)
    for vertex in shape.verts:
        vertex.co += vertex.co.__class__([rng.uniform(-0.02, 0.02) for _ in range(3)])
    mesh = bpy.data.meshes.new(f"{kind}")
    shape.to_mesh(mesh)
    shape.free()
    return mesh


def random_values(numbers, kind, count):
    if kind in {"FLOAT", "FLOAT2", "FLOAT_VECTOR"}:
        columns = {"FLOAT": 1, "FLOAT2": 2, "FLOAT_VECTOR": 3}[kind]
        return numbers.uniform(-9, 9, count * columns).astype(np.float32)
    if kind in {"FLOAT_COLOR", "BYTE_COLOR"}:
        return numbers.uniform(0, 1, count * 4).astype(np.float32)
    if kind == "BOOLEAN":
        return numbers.integers(0, 2, count).astype(bool)
    return numbers.integers(-100, 100, count).astype(np.int32)


PROPERTY = {"FLOAT2": "vector", "FLOAT_VECTOR": "vector", "FLOAT_COLOR": "color",
            "BYTE_COLOR": "color"}  # fmt: skip


def dress(thing, seed):
    """Gives an object UV maps, attributes of each type and domain, colours, materials, seams, sharp
    edges, creases, smooth faces, vertex groups, shape keys: a random choice of each."""
    rng, numbers = random.Random(seed), np.random.default_rng(seed)
    mesh = thing.data
    for name in rng.sample(["UVMap", "lightmap", "third"], rng.randint(0, 3)):
        uv = mesh.uv_layers.new(name=name)
        uv.data.foreach_set("uv", numbers.uniform(0, 1, 2 * len(mesh.loops)).astype(np.float32))
    sizes = {"POINT": len(mesh.vertices), "EDGE": len(mesh.edges), "FACE": len(mesh.polygons),
             "CORNER": len(mesh.loops)}  # fmt: skip
    for kind in ("FLOAT", "INT", "INT8", "BOOLEAN", "FLOAT_VECTOR", "FLOAT2", "FLOAT_COLOR",
                 "BYTE_COLOR"):  # fmt: skip
        domains = ["POINT", "CORNER"] if kind.endswith("COLOR") else list(sizes)
        for domain in rng.sample(domains, rng.randint(0, 2)):
            attribute = mesh.attributes.new(f"{kind} {domain}", kind, domain)
            values = random_values(numbers, kind, sizes[domain])
            attribute.data.foreach_set(PROPERTY.get(kind, "value"), values)
    for i in range(rng.randint(0, 3)):
        mesh.materials.append(bpy.data.materials.new(f"paint {i}"))
    if len(mesh.materials):
        index = numbers.integers(0, len(mesh.materials), len(mesh.polygons)).astype(np.int32)
        mesh.polygons.foreach_set("material_index", index)
    for edge in mesh.edges:
        edge.use_seam = rng.random() < 0.2
        edge.use_edge_sharp = rng.random() < 0.2
        edge.crease = rng.choice([0.0, 0.0, 0.5, 1.0])
        edge.bevel_weight = rng.choice([0.0, 0.0, 0.25])
    smooth = numbers.integers(0, 2, len(mesh.polygons)).astype(bool)
    mesh.polygons.foreach_set("use_smooth", smooth)
    for i in range(rng.randint(0, 3)):
        group = thing.vertex_groups.new(name=f"bone {i}")
        for vertex in range(len(mesh.vertices)):
            if rng.random() < 0.5:
                group.add([vertex], rng.random(), "REPLACE")
    if rng.random() < 0.5:
        thing.shape_key_add(name="Basis")
        for name in ("smile", "frown"):
            key = thing.shape_key_add(name=name, from_mix=False)
            co = np.empty(3 * len(mesh.vertices), np.float32)
            key.data.foreach_get("co", co)
            key.data.foreach_set("co", co + numbers.normal(0, 0.1, len(co)).astype(np.float32))
            key.value = rng.random()
    mesh.update()
