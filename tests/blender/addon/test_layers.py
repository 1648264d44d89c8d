"""What a mesh carries comes through: equal to the bit away from cracks, between its neighbours at
them. The check looks vertices up by place, and knows nothing of how they were carried."""

import random
import unittest.mock

import bpy
import meshes
import numpy as np
from cracking import Cracking, get

from craze_blender import layers

RECIPE = """
[stress]
noise = 0.05
[material]
criterion = "strength"
scatter = 0.15
[layer]
relative_spacing = 0.2
[evolution]
max_load = 2.0
"""


class Places:
    """Of an object's mesh: which vertex is where, and which elements are between which vertices."""

    def __init__(self, thing):
        self.thing, self.mesh = thing, thing.data
        co = get(self.mesh.vertices, "co", 3)
        self.key = [row.tobytes() for row in co]
        self.vertex = {key: i for i, key in enumerate(self.key)}
        self.edge = {
            frozenset(self.key[v] for v in e.vertices): e.index for e in self.mesh.edges
        }
        self.loop = {}
        for p in self.mesh.polygons:
            for i in p.loop_indices:
                self.loop[p.index, self.key[self.mesh.loops[i].vertex_index]] = i


def layer_values(mesh):
    """{(name, domain): (n, c) array} of everything per element."""
    found = {}
    for uv in mesh.uv_layers:
        found["uv " + uv.name, "CORNER"] = get(uv.data, "uv", 2)
    for a in mesh.attributes:
        if a.name.startswith("."):
            continue
        columns = {"FLOAT2": 2, "FLOAT_VECTOR": 3, "FLOAT_COLOR": 4, "BYTE_COLOR": 4}
        name = meshes.PROPERTY.get(a.data_type, "value")
        dtype = {"INT": np.int32, "INT8": np.int32, "BOOLEAN": bool}.get(a.data_type, np.float32)
        found[a.name, a.domain] = get(a.data, name, columns.get(a.data_type, 1), dtype)
    for name, dtype in (("use_seam", bool), ("use_edge_sharp", bool), ("crease", np.float32),
                        ("bevel_weight", np.float32)):  # fmt: skip
        found[name, "EDGE"] = get(mesh.edges, name, 1, dtype)
    found["use_smooth", "FACE"] = get(mesh.polygons, "use_smooth", 1, bool)
    found["material_index", "FACE"] = get(mesh.polygons, "material_index", 1, np.int32)
    return found


def weights(thing):
    """[{group name: weight}] of each vertex."""
    names = [g.name for g in thing.vertex_groups]
    return [{names[g.group]: g.weight for g in v.groups} for v in thing.data.vertices]


class Layers(Cracking):
    recipe = RECIPE

    def test_random_meshes_with_random_layers_come_through(self):
        for seed in range(25):
            with self.subTest(seed=seed):
                meshes.empty()
                thing = meshes.link(meshes.random_shape(random.Random(seed)))
                meshes.dress(thing, seed)
                with unittest.mock.patch.object(layers, "ROWS", 50 if seed % 2 else layers.ROWS):
                    cracked = self.crack(thing, seed=seed)  # in many steps, or few
                self.assertFalse(cracked.data.validate())
                self.assertGreater(len(cracked.data.vertices), len(thing.data.vertices))
                self.check(thing, cracked)

    def check(self, thing, cracked):
        before, after = Places(thing), Places(cracked)
        old, new = layer_values(thing.data), layer_values(cracked.data)
        self.assertLessEqual(set(old), set(new))
        self.assertEqual([m.name for m in thing.data.materials],
                         [m.name for m in cracked.data.materials])  # fmt: skip
        source = get(cracked.data.attributes["source_face"].data, "value", 1, np.int32)[:, 0]
        pairs = {"POINT": [], "EDGE": [], "FACE": list(enumerate(source)), "CORNER": []}
        pairs["POINT"] = [
            (i, before.vertex[key]) for i, key in enumerate(after.key) if key in before.vertex
        ]
        # Every vertex that no crack moved is there; a crack's own vertex has its sides.
        there = {old_ for _, old_ in pairs["POINT"]}
        self.assertGreater(len(there), 0.5 * len(thing.data.vertices))
        for edge in cracked.data.edges:
            ends = frozenset(after.key[v] for v in edge.vertices)
            if ends in before.edge:
                pairs["EDGE"].append((edge.index, before.edge[ends]))
        for p in cracked.data.polygons:
            for i in p.loop_indices:
                spot = source[p.index], after.key[cracked.data.loops[i].vertex_index]
                if spot in before.loop:
                    pairs["CORNER"].append((i, before.loop[spot]))
        for (name, domain), values in old.items():
            found = np.array(pairs[domain]).reshape(-1, 2)
            a, b = new[name, domain][found[:, 0]], values[found[:, 1]]
            self.assertEqual(a.tobytes(), b.tobytes(), f"{name} of {domain}")
        self.check_weights(thing, cracked, pairs["POINT"])
        self.check_keys(thing, cracked, pairs["POINT"])
        self.check_between(old, new, source, before, cracked)

    def check_weights(self, thing, cracked, pairs):
        self.assertEqual([g.name for g in thing.vertex_groups],
                         [g.name for g in cracked.vertex_groups])  # fmt: skip
        old, new = weights(thing), weights(cracked)
        for i, j in pairs:
            self.assertEqual(new[i], old[j])

    def check_keys(self, thing, cracked, pairs):
        keys = thing.data.shape_keys
        if keys is None:
            self.assertIsNone(cracked.data.shape_keys)
            return
        found = np.array(pairs)
        for block in keys.key_blocks:
            new = cracked.data.shape_keys.key_blocks[block.name]
            self.assertEqual(new.value, block.value)
            a, b = get(new.data, "co", 3)[found[:, 0]], get(block.data, "co", 3)[found[:, 1]]
            self.assertEqual(a.tobytes(), b.tobytes(), block.name)

    def check_between(self, old, new, source, before, cracked):
        """A number at a corner lies between those of the polygon that it comes from."""
        for (name, domain), values in old.items():
            if domain != "CORNER" or values.dtype != np.float32 or name.startswith("BYTE"):
                continue
            made = new[name, domain]
            for p in cracked.data.polygons:
                whole = values[list(before.mesh.polygons[source[p.index]].loop_indices)]
                part = made[list(p.loop_indices)]
                self.assertTrue((part >= whole.min(axis=0) - 1e-5).all(), name)
                self.assertTrue((part <= whole.max(axis=0) + 1e-5).all(), name)

    def test_polygons_that_no_crack_touches_stay_polygons(self):
        thing = meshes.link(meshes.grid(60))
        cracked = self.crack(thing)
        before, after = Places(thing), Places(cracked)
        old = {frozenset(before.key[v] for v in p.vertices) for p in thing.data.polygons}
        quads = [p for p in cracked.data.polygons if len(p.vertices) == 4]
        self.assertGreater(len(quads), len(old) / 4)
        for p in quads:
            self.assertIn(frozenset(after.key[v] for v in p.vertices), old)
        area = sum(p.area for p in cracked.data.polygons)
        self.assertAlmostEqual(area, sum(p.area for p in thing.data.polygons), places=4)

    def test_walls_take_the_layers_of_their_rim_and_a_slot_of_their_own(self):
        thing = meshes.link(meshes.random_shape(random.Random(3)))
        meshes.dress(thing, 3)
        materials = len(thing.data.materials)
        cracked = self.crack(thing, recipe=RECIPE + "[post]\ngap = 0.1\nwall = 0.05\n")
        source = get(cracked.data.attributes["source_face"].data, "value", 1, np.int32)[:, 0]
        index = get(cracked.data.polygons, "material_index", 1, np.int32)[:, 0]
        self.assertEqual(cracked.data.materials[-1].name, "crack_wall")
        self.assertEqual(len(cracked.data.materials), max(materials, 1) + 1)
        np.testing.assert_array_equal(source < 0, index == len(cracked.data.materials) - 1)
        self.assertTrue((source < 0).any())
        names = set(layer_values(cracked.data))
        self.assertLessEqual(set(layer_values(thing.data)), names)

    def test_what_no_face_has_is_kept(self):
        mesh = meshes.grid(8)
        n = len(mesh.vertices)
        mesh.vertices.add(2)
        mesh.vertices[n].co, mesh.vertices[n + 1].co = (0, 0, 3), (0, 1, 3)
        mesh.edges.add(1)
        mesh.edges[-1].vertices = (n, n + 1)
        mesh.edges[-1].use_seam = True
        mesh.update()
        cracked = self.crack(meshes.link(mesh))
        wires = [e for e in cracked.data.edges if e.is_loose]
        self.assertEqual(len(wires), 1)
        self.assertTrue(wires[0].use_seam)
        ends = sorted(tuple(cracked.data.vertices[v].co) for v in wires[0].vertices)
        self.assertEqual(ends, [(0, 0, 3), (0, 1, 3)])

    def test_modifiers_are_applied_and_armatures_go_on(self):
        thing = meshes.link(meshes.grid(6))
        rig = bpy.data.objects.new("rig", bpy.data.armatures.new("rig"))
        bpy.context.scene.collection.objects.link(rig)
        thing.modifiers.new("rig", "ARMATURE").object = rig
        thing.modifiers.new("finer", "SUBSURF").levels = 1
        group = thing.vertex_groups.new(name="bone")
        group.add(range(len(thing.data.vertices)), 0.25, "REPLACE")
        cracked = self.crack(thing)
        self.assertEqual([m.name for m in cracked.modifiers], ["rig"])
        self.assertEqual([m.name for m in thing.modifiers], ["rig", "finer"])
        self.assertGreater(len(cracked.data.vertices), 2 * len(thing.data.vertices))
        self.assertEqual({w["bone"] for w in weights(cracked)}, {0.25})

    def test_custom_normals_come_through(self):
        mesh = meshes.grid(40)
        normals = np.random.default_rng(1).normal(0, 0.2, (len(mesh.loops), 3)) + (0, 0, 1)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        mesh.use_auto_smooth = True
        mesh.normals_split_custom_set(normals)
        thing = meshes.link(mesh)
        cracked = self.crack(thing)
        before, after = Places(thing), Places(cracked)
        thing.data.calc_normals_split()
        cracked.data.calc_normals_split()
        old, new = get(thing.data.loops, "normal", 3), get(cracked.data.loops, "normal", 3)
        source = get(cracked.data.attributes["source_face"].data, "value", 1, np.int32)[:, 0]
        checked = 0
        for p in cracked.data.polygons:
            for i in p.loop_indices:
                spot = source[p.index], after.key[cracked.data.loops[i].vertex_index]
                if spot in before.loop and len(p.vertices) == 4:
                    # Blender keeps them in 16 bits, from a frame at each corner.
                    np.testing.assert_allclose(new[i], old[before.loop[spot]], atol=1e-3)
                    checked += 1
        self.assertGreater(checked, 20)

    def test_a_smooth_surface_does_not_bend_into_its_cracks(self):
        mesh = meshes.grid(40)
        mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
        cracked = self.crack(meshes.link(mesh), recipe=RECIPE + "[post]\ngap = 0.1\nwall = 0.05\n").data
        cracked.calc_normals_split()
        normals = get(cracked.loops, "normal", 3)
        source = get(cracked.attributes["source_face"].data, "value", 1, np.int32)[:, 0]
        self.assertTrue((source < 0).any(), "there are walls")
        flat = np.repeat(source >= 0, get(cracked.polygons, "loop_total", 1, np.int32)[:, 0])
        np.testing.assert_allclose(normals[flat], np.tile((0, 0, 1), (flat.sum(), 1)), atol=1e-6)
