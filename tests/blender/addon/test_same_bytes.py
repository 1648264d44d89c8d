"""The same mesh and recipe give the same bytes inside Blender and from the command."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import bpy
import meshes
import numpy as np
from cracking import places

from craze_blender import mesh_in, table

COMMAND = os.environ.get("CRAZE_COMMAND", "")


def ply(path):
    """{element: {property: array}} of a binary PLY file."""
    data = path.read_bytes()
    head, _, body = data.partition(b"end_header\n")
    types = {"double": "<f8", "float": "<f4", "int": "<i4", "uint": "<u4", "uchar": "u1"}
    found, at, element = {}, 0, None
    elements = []
    for line in head.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            element = (words[1], int(words[2]), [])
            elements.append(element)
        elif words[0] == "property":
            element[2].append(words[1:])
    for name, count, properties in elements:
        fields = []
        for words in properties:
            if words[0] == "list":
                # All lists are of triangles: three indices, or three corners' UVs.
                size = {"vertex_indices": 3, "texcoord": 6}[words[3]]
                fields += [(words[3] + " n", types[words[1]]), (words[3], types[words[2]], size)]
            else:
                fields.append((words[1], types[words[0]]))
        rows = np.frombuffer(body, np.dtype(fields), count, at)
        at += rows.nbytes
        found[name] = rows
    return found


@unittest.skipUnless(COMMAND, "without the command")
class SameBytes(unittest.TestCase):
    def setUp(self):
        meshes.empty()

    def compare(self, mesh, *options, **said):
        thing = meshes.link(mesh)
        bpy.ops.craze.crack(**said)
        cracked = bpy.context.active_object.data
        with tempfile.TemporaryDirectory() as folder:
            given, made = Path(folder) / "in.ply", Path(folder) / "out.ply"
            write(given, thing.data)
            subprocess.run([COMMAND, "crack", given, "-o", made, "--quiet", *options], check=True)
            found = ply(made)
        vertex, face = found["vertex"], found["face"]
        co = np.empty(3 * len(cracked.vertices), np.float32)
        cracked.vertices.foreach_get("co", co)
        theirs = np.stack([vertex[k] for k in "xyz"], axis=1).astype(np.float32)
        self.assertEqual(co.tobytes(), theirs.tobytes())
        for name in ("crack_distance", "crack_time", "crack_growth"):
            values = np.empty(len(vertex), np.float32)
            cracked.attributes[name].data.foreach_get("value", values)
            self.assertEqual(values.tobytes(), vertex[name].astype(np.float32).tobytes(), name)
        # Blender's polygons that are whole again are two of theirs.
        cracked.calc_loop_triangles()
        ours = {frozenset(t.vertices) for t in cracked.loop_triangles}
        self.assertEqual(ours, {frozenset(f) for f in face["vertex_indices"].tolist()})

    def test_of_each_preset(self):
        for preset in ("mud", "glaze", "paint"):
            with self.subTest(preset=preset):
                meshes.empty()
                options = ["--preset", preset, "--seed", "5", "--set", "layer.spacing=0.4"]
                self.compare(meshes.grid(12), *options, preset=preset, seed=5, spacing=0.4)

    def test_of_a_recipe_with_gaps_and_walls(self):
        with tempfile.TemporaryDirectory() as folder:
            recipe = Path(folder) / "mine.toml"
            text = table.toml(table.PRESETS["mud"])
            text = text.replace("gap = 0.0", "gap = 0.1").replace("wall = 0.0", "wall = 0.05")
            recipe.write_text(text.replace("\nspacing = 0.0", "\nspacing = 0.4"))
            self.compare(meshes.grid(12), "--recipe", str(recipe), recipe=str(recipe))

    def test_an_untouched_panel_says_what_the_preset_says(self):
        from craze_blender import panel_recipe

        for preset in table.PRESETS:
            with self.subTest(preset=preset):
                panel = bpy.context.scene.craze
                panel.preset = preset
                for row in table.PARAMETERS:
                    if row["key"] not in {"post.gap", "post.wall", "post.curl"}:
                        continue
                    own = table.PRESETS[preset]["post"][row["key"].removeprefix("post.")]
                    setattr(
                        panel.keys,
                        table.property_name(row["key"]),
                        panel_recipe.to_property(row, own),
                    )
                panel.keys.seed = 1
                self.assertEqual(panel_recipe.recipe_of(panel, list), table.PRESETS[preset])

    def test_cracks_opened_otherwise_are_as_those_of_a_run(self):
        """What the panel says of how cracks are open needs no second run, and gives what one gives."""
        from craze_blender import cracked, live

        panel = bpy.context.scene.craze
        for preset, name, value in (
            ("mud", "gap", 0.3), ("mud", "gap_width", 0.02), ("mud", "roughness", 0.02),
            ("mud", "thickness", 0.1), ("mud", "curl", 0.5), ("bark", "wall", 0.05),
        ):  # fmt: skip
            with self.subTest(preset=preset, name=name):
                meshes.empty()
                panel.preset = preset
                panel.keys.layer_spacing, panel.keys.post_gap = 0.5, 0.0 if preset == "bark" else 0.1
                meshes.link(meshes.grid(12))
                bpy.ops.craze.crack()
                thing = bpy.context.active_object
                first, run = places(thing.data), thing.craze.run
                setattr(panel.keys, f"post_{name}", value)
                work = live.start(thing, "open", bpy.context.scene)
                work.finish()
                self.assertEqual(work.state, "done", work.error)
                live.finish(thing, work)
                opened, said = places(thing.data), cracked.post_of(thing)
                found = numbers(thing)
                self.assertEqual(thing.craze.run, run)
                self.assertFalse(np.array_equal(opened, first))
                bpy.ops.craze.crack()
                self.assertNotEqual(thing.craze.run, run)
                np.testing.assert_array_equal(places(thing.data), opened)
                self.assertEqual(cracked.post_of(thing), said)
                self.assertEqual(numbers(thing), found)
                setattr(panel.keys, f"post_{name}", 0.0)
        panel.preset, panel.keys.post_gap, panel.keys.layer_spacing = "mud", 0.1, 0.0

    def test_what_is_changed_takes_back_what_says_the_same_in_another_way(self):
        from craze_blender import panel_recipe

        panel = bpy.context.scene.craze
        panel.preset = "bark"
        panel.keys.post_gap = 0  # other presets keep what was theirs
        self.assertEqual(panel_recipe.recipe_of(panel, list)["post"]["gap_width"], "0.5%")
        panel.keys.post_gap = 0.25
        post = panel_recipe.recipe_of(panel, list)["post"]
        self.assertEqual((post["gap"], post["gap_width"]), (0.25, 0))
        panel.keys.post_gap_width = 0.5
        post = panel_recipe.recipe_of(panel, list)["post"]
        self.assertEqual((post["gap"], post["gap_width"]), (0, 0.5))
        panel.keys.post_gap = panel.keys.post_gap_width = 0


def numbers(thing):
    """What its report says of the pattern."""
    report = json.loads(thing.craze.report)
    return {name: report[name] for name in ("cracks", "statistics", "output", "recipe")}


def write(path, mesh):
    """Triangles and UVs of a Blender mesh as the engine reads them."""
    mesh.calc_loop_triangles()
    arrays = dict(mesh_in.arrays_of(mesh, np.eye(3)))
    head = f"""ply
format binary_little_endian 1.0
element vertex {len(arrays["vertices"])}
property double x
property double y
property double z
element face {len(arrays["triangles"])}
property list uchar int vertex_indices
property list uchar double texcoord
end_header
"""
    faces = np.zeros(
        len(arrays["triangles"]),
        [("n", "u1"), ("v", "<i4", 3), ("m", "u1"), ("t", "<f8", 6)],
    )
    faces["n"], faces["m"] = 3, 6
    faces["v"] = arrays["loop_vertex"][arrays["triangles"]]
    faces["t"] = arrays["uv"][arrays["triangles"]].reshape(-1, 6)
    vertices = arrays["vertices"].astype("<f8").tobytes()
    path.write_bytes(head.encode() + vertices + faces.tobytes())
