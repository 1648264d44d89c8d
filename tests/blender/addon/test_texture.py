"""Tileable materials as assets."""

import os
import subprocess
import tempfile
import unittest
import uuid
from pathlib import Path

import bpy
import meshes
import numpy as np
from test_bake import pixels

from craze_blender import assets, process, table, tile_material

COMMAND = os.environ.get("CRAZE_COMMAND", "")
SPACING = 0.2
# What feeds which socket of the shader.
SHADER = {"Base Color": "ShaderNodeMix", "Roughness": "ShaderNodeTexImage",
          "Normal": "ShaderNodeNormalMap"}  # fmt: skip


def image_of(material, name):
    return material.node_tree.nodes[f"Craze {name}"].image


class Texture(unittest.TestCase):
    def setUp(self):
        meshes.empty()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        bpy.context.scene.craze.preset = "mud"

    def make(self, **said):
        before = set(bpy.data.materials)
        said = {"preset": "mud", "spacing": SPACING, "size": 32, **said}
        self.assertEqual(bpy.ops.craze.texture(**said), {"FINISHED"})
        [made] = set(bpy.data.materials) - before
        return made

    def check_asset(self, made):
        about = made.asset_data
        self.assertEqual({t.name for t in about.tags}, {"cracks", "tileable", "mud"})
        self.assertEqual(about.catalog_id, assets.catalogue("Craze/Mud"))
        uuid.UUID(about.catalog_id)
        self.assertIn(table.DESCRIPTIONS["mud"], about.description)
        shown = np.array(made.preview.image_pixels_float).reshape(*made.preview.image_size, 4)
        self.assertEqual(shown.shape[:2], (32, 32))
        self.assertGreater(shown[:, :, :3].std(), 0.02)  # cracks are seen
        self.assertTrue((shown[:, :, 3] == 1).all())

    def test_it_is_an_asset_of_this_file_with_packed_images(self):
        made = self.make()
        self.check_asset(made)
        before = {n: pixels(image_of(made, n)).tobytes() for n in tile_material.USED}
        self.assertEqual(os.listdir(process.engine().folder), [])
        path, name = str(self.folder / "saved.blend"), made.name
        bpy.ops.wm.save_as_mainfile(filepath=path)
        bpy.ops.wm.open_mainfile(filepath=path)
        again = bpy.data.materials[name]
        self.check_asset(again)
        for map_name, values in before.items():
            image = image_of(again, map_name)
            self.assertIsNotNone(image.packed_file)
            self.assertEqual(tuple(image.size), (32, 32))
            self.assertEqual(pixels(image).tobytes(), values, map_name)

    def test_every_image_reaches_the_shader(self):
        made = self.make()
        tree = made.node_tree
        shader = tile_material.principled(tree)
        for name, kind in SHADER.items():
            self.assertEqual(shader.inputs[name].links[0].from_node.bl_idname, kind, name)
        output = tree.get_output_node("ALL")
        height = output.inputs["Displacement"].links[0].from_node
        self.assertEqual((height.inputs["Midlevel"].default_value, height.inputs["Scale"].default_value),
                         (0, 1))  # fmt: skip
        for name in tile_material.USED:
            node = tree.nodes[f"Craze {name}"]
            self.assertTrue(node.outputs["Color"].is_linked, name)
            self.assertEqual(node.inputs["Vector"].links[0].from_node.name, tile_material.PLACE)
            if name != "base_color":
                self.assertEqual(node.image.colorspace_settings.name, "Non-Color", name)

    @unittest.skipUnless(COMMAND, "without the command")
    def test_the_images_are_those_of_the_command(self):
        made = self.make(seed=4, period=2.0, spacing=0.4)
        subprocess.run(
            [COMMAND, "texture", "mud", "-o", self.folder, "--seed", "4", "--period", "2", "--set",
             "layer.spacing=0.4", "--set", "mesh.unit=m", "--size", "32", "--map-format", "exr",
             "--no-previews", "--quiet"], check=True,
        )  # fmt: skip
        for name in tile_material.USED:
            packed = image_of(made, name).packed_file.data
            self.assertEqual(packed, (self.folder / f"{name}.exr").read_bytes(), name)

    def test_tiles_continue_each_other(self):
        """Across the border neighbours differ by no more than neighbours inside."""
        height = pixels(image_of(self.make(size=128), "height"))
        self.assertLess(height.min(), 0)
        for values in (height, height.T):
            inside = np.abs(np.diff(values, axis=0)).max()
            self.assertLessEqual(np.abs(values[0] - values[-1]).max(), inside)

    def test_a_library_gets_a_file_and_a_catalogue(self):
        library = self.folder / "library"
        made = self.make(directory=str(library))
        self.assertIsNone(made.asset_data)  # the asset is the library's
        self.make(directory=str(library), preset="glaze")
        self.make(directory=str(library), seed=2)
        self.assertEqual(
            sorted(p.name for p in library.iterdir()),
            ["Glaze_tile.blend", "Mud_tile.blend", "Mud_tile_001.blend", assets.CATALOGUES],
        )
        lines = (library / assets.CATALOGUES).read_text("utf-8").splitlines()
        self.assertIn("VERSION 1", lines)
        listed = {line.split(":")[0]: line.split(":")[1] for line in lines if line.count(":") == 2
                  and not line.startswith("#")}  # fmt: skip
        self.assertEqual(listed, {assets.catalogue(p): p for p in ("Craze/Mud", "Craze/Glaze")})
        meshes.empty()
        with bpy.data.libraries.load(str(library / "Mud_tile.blend"), assets_only=True) as (there, here):
            self.assertEqual(there.materials, ["Mud tile"])
            here.materials = there.materials
        self.check_asset(here.materials[0])
        self.assertIsNotNone(image_of(here.materials[0], "height").packed_file)

    def test_a_list_of_catalogues_keeps_what_it_has(self):
        file = self.folder / assets.CATALOGUES
        file.write_text("# mine\nVERSION 1\n\nf00d0000-0000-4000-8000-000000000001:Stone:Stone")
        self.make(directory=str(self.folder))
        text = file.read_text("utf-8")
        self.assertTrue(text.startswith("# mine\nVERSION 1\n\nf00d0000-"))
        self.assertEqual(text.count("Stone:Stone\n"), 1)
        self.assertEqual(text.count("Craze/Mud"), 1)

    def test_the_panel_says_what_is_not_said(self):
        panel = bpy.context.scene.craze
        panel.preset, panel.tile, panel.map_size = "glaze", 0.5, 16
        panel.keys.layer_spacing = 0.1
        try:
            self.assertEqual(bpy.ops.craze.texture(), {"FINISHED"})
        finally:
            panel.tile, panel.map_size = 1.0, 1024
            panel.keys.layer_spacing, panel.preset = 0.0, "mud"
        made = bpy.data.materials["Glaze tile"]
        self.assertEqual(tuple(image_of(made, "normal").size), (16, 16))
        self.assertIn("0.5 a side", made.asset_data.description)

    def test_what_is_amiss_is_one_sentence_and_leaves_nothing(self):
        bpy.ops.wm.read_homefile(use_empty=True)
        (self.folder / "file").write_text("")
        old = self.folder / "old"
        old.mkdir()
        (old / assets.CATALOGUES).write_text("VERSION 9\n")
        group = 'stress.attribute = "pull"\nlayer.spacing = 0.2\n'
        for said, words in (
            ({"spacing": 0.5}, "tile too small for its pattern"),
            ({"preset": "mud", "recipe": "layer.spacing = 0.1"}, "not both"),
            ({"directory": "//library"}, "never saved"),
            ({"directory": str(self.folder / "file")}, "file: (File exists|Not a directory)"),
            ({"directory": str(old)}, "version that is not known"),
        ):
            with self.subTest(said=said), self.assertRaisesRegex(RuntimeError, f"^Error: craze: .*{words}"):
                bpy.ops.craze.texture(**{"preset": "mud", "spacing": SPACING, "size": 8, **said})
        with self.assertRaisesRegex(RuntimeError, "^Error: craze: .*attribute"):
            bpy.ops.craze.texture(recipe=group, size=8)
        self.assertEqual(len(bpy.data.materials), 0)
        self.assertEqual(len(bpy.data.images), 0)
        self.assertEqual(os.listdir(process.engine().folder), [])

    def test_a_recipe_is_enough(self):
        made = self.make(preset="PANEL", recipe="layer.spacing = 0.2\nmaterial.criterion = 'strength'\n",
                         spacing=0.0)  # fmt: skip
        self.assertEqual(made.name, "Cracks tile")
        self.assertEqual(made.asset_data.catalog_id, assets.catalogue("Craze/Cracks"))
