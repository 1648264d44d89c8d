"""Baked maps: images, and materials that show them."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import bpy
import meshes
import numpy as np
from cracking import Cracking, get, recipe_of

from craze_blender import crack_nodes, process

COMMAND = os.environ.get("CRAZE_COMMAND", "")
MAPS = {
    "mask", "height", "normal", "occlusion", "curvature", "distance", "width", "direction", "time",
    "crack", "fragment", "position",
}  # fmt: skip


def pixels(image):
    """(h, w) of the red channel, row 0 at the bottom."""
    width, height = image.size
    values = np.empty(width * height * image.channels, np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(height, width, -1)[:, :, 0]


def group_of(material):
    return material.node_tree.nodes[crack_nodes.GROUP]


def image_of(material, name):
    return material.node_tree.nodes[f"Craze {name}"].image


def halves():
    """A grid, whether each polygon is in its right half, and its UVs, 0 … 1."""
    mesh = meshes.grid(8)
    right = np.array([p.center.x > 0 for p in mesh.polygons])
    return mesh, right, get(mesh.uv_layers.active.data, "uv", 2) + np.float32(0.5)


class Bake(Cracking):
    recipe = recipe_of("relative_spacing = 0.2", "gap = 0.05, wall = 0.03")

    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def bake(self, **said):
        self.assertEqual(bpy.ops.craze.bake(**said), {"FINISHED"})
        return bpy.context.active_object

    def test_without_a_folder_images_are_in_the_file(self):
        self.crack(meshes.link(meshes.grid(8)))
        made = self.bake(size=64)
        [material] = [m for m in made.data.materials if m.name != "crack_wall"]
        path = str(self.folder / "saved.blend")
        name = material.name
        before = {n: pixels(image_of(material, n)).tobytes() for n in ("mask", "height", "distance")}
        self.assertEqual(os.listdir(process.engine().folder), [])
        bpy.ops.wm.save_as_mainfile(filepath=path)
        bpy.ops.wm.open_mainfile(filepath=path)
        material = bpy.data.materials[name]
        for map_name, values in before.items():
            image = image_of(material, map_name)
            self.assertIsNotNone(image.packed_file)
            self.assertEqual(tuple(image.size), (64, 64))
            self.assertEqual(image.colorspace_settings.name, "Non-Color")
            self.assertEqual(pixels(image).tobytes(), values)

    def test_the_mask_shows_the_cracks(self):
        """The groove is in the mask, of the wall's depth, and where the distance is small."""
        self.crack(meshes.link(meshes.grid(8)))
        material = self.bake(size=128, directory=str(self.folder)).data.materials[0]
        mask = pixels(image_of(material, "mask"))
        height = pixels(image_of(material, "height"))
        distance = pixels(image_of(material, "distance"))
        self.assertTrue((mask > 0.99).any() and (mask == 0).any())
        self.assertTrue((height[mask == 0] == 0).all())
        self.assertTrue(-0.03 - 1e-6 < height.min() < -0.02)  # the wall's depth, over a pixel
        self.assertLess(distance[mask > 0.99].max(), distance[mask == 0].min() + 0.03)

    @unittest.skipUnless(COMMAND, "without the command")
    def test_a_folder_has_the_files_of_the_command(self):
        import test_same_bytes

        thing = meshes.link(meshes.grid(8))
        recipe = self.folder / "r.toml"
        recipe.write_text(self.recipe)
        self.crack(thing, recipe=str(recipe))
        ours, theirs = self.folder / "ours", self.folder / "theirs"
        self.bake(size=32, directory=str(ours))
        given = self.folder / "in.ply"
        test_same_bytes.write(given, thing.data)
        subprocess.run(
            [COMMAND, "crack", given, "--recipe", recipe, "--quiet", "--maps", theirs,
             "--map-size", "32", "--map-format", "exr"], check=True,
        )  # fmt: skip
        self.assertEqual({p.name for p in ours.iterdir()}, {p.name for p in theirs.iterdir()})
        self.assertEqual({p.stem for p in ours.iterdir()}, MAPS | {"maps"})
        for path in ours.iterdir():
            self.assertEqual(path.read_bytes(), (theirs / path.name).read_bytes(), path.name)

    def test_how_cracks_are_open_by_now_is_what_is_baked(self):
        new = self.crack(meshes.link(meshes.grid(8)))
        flat = pixels(image_of(self.bake(size=32).data.materials[0], "height"))
        recipe = json.loads(new.craze.recipe)
        recipe["post"].update(gap=0.0, gap_width=0.05, curl=1.0, roughness=0.02)
        new.craze.recipe = json.dumps(recipe)
        height = pixels(image_of(self.bake(size=32).data.materials[0], "height"))
        self.assertEqual(flat.max(), 0)
        self.assertGreater(height.max(), 0)
        self.assertLess(height.min(), 0)
        rough = self.lines()
        recipe["post"].update(roughness=0.0)
        new.craze.recipe = json.dumps(recipe)
        meshes.activate(new)
        self.assertLess(self.lines(), rough)

    def lines(self):
        """How many points its cracks have as curves."""
        self.assertEqual(bpy.ops.craze.curves(), {"FINISHED"})
        return sum(len(s.points) for s in bpy.context.active_object.data.splines)

    def test_materials_are_copied_and_go_on_with_what_they_had(self):
        thing = meshes.link(meshes.grid(8))
        paint = bpy.data.materials.new("paint")
        paint.use_nodes = True
        nodes, links = paint.node_tree.nodes, paint.node_tree.links
        colour = nodes.new("ShaderNodeRGB").outputs[0]
        links.new(colour, nodes["Principled BSDF"].inputs["Base Color"])
        nodes["Principled BSDF"].inputs["Roughness"].default_value = 0.125
        thing.data.materials.append(paint)
        self.crack(thing)
        made = self.bake(size=16)
        material = made.data.materials[0]
        self.assertEqual(material.name, "paint cracks")
        self.assertEqual(thing.data.materials[0], paint)
        self.assertNotIn(crack_nodes.GROUP, paint.node_tree.nodes)
        group = group_of(material)
        self.assertEqual(group.node_tree.name, crack_nodes.GROUP)
        self.assertEqual(group.inputs["Color"].links[0].from_node.bl_idname, "ShaderNodeRGB")
        shader = material.node_tree.nodes["Principled BSDF"]
        self.assertEqual(shader.inputs["Base Color"].links[0].from_node, group)
        self.assertEqual(shader.inputs["Normal"].links[0].from_node, group)
        self.assertEqual(shader.inputs["Roughness"].default_value, 0.125)
        for name in ("Mask", "Height", "Distance"):
            self.assertTrue(group.inputs[name].is_linked, name)
        self.assertEqual(made.data.materials[-1].name, "crack_wall")

    def test_baking_again_takes_new_images_and_no_second_group(self):
        self.crack(meshes.link(meshes.grid(8)))
        self.bake(size=16)
        counts = [len(d) for d in (bpy.data.images, bpy.data.materials, bpy.data.node_groups)]
        material = self.bake(size=32).data.materials[0]
        self.assertEqual(tuple(image_of(material, "mask").size), (32, 32))
        again = [len(d) for d in (bpy.data.images, bpy.data.materials, bpy.data.node_groups)]
        self.assertEqual(again, counts)
        self.assertEqual([n.bl_idname for n in material.node_tree.nodes].count("ShaderNodeGroup"), 1)

    def test_materials_stay_when_the_object_is_cracked_anew(self):
        made = self.crack(meshes.link(meshes.grid(8)))
        self.bake(size=16)
        names = [m.name for m in made.data.materials]
        self.crack(made, seed=9)
        self.assertEqual([m.name for m in made.data.materials], names)
        self.crack(made, recipe=self.recipe.replace("wall = 0.03", "wall = 0.0"))
        self.assertEqual([m.name for m in made.data.materials], names[:1])

    def test_materials_that_use_the_same_uvs_have_sets_of_their_own(self):
        mesh, right, uv = halves()
        for name in ("left side", "right"):
            mesh.materials.append(bpy.data.materials.new(name))
        mesh.polygons.foreach_set("material_index", right.astype(np.int32))
        uv[:, 0] -= 0.5 * np.repeat(right, 4)
        mesh.uv_layers.active.data.foreach_set("uv", uv.reshape(-1))
        self.crack(meshes.link(mesh))
        made = self.bake(size=16, directory=str(self.folder))
        shown = [image_of(m, "mask").filepath for m in made.data.materials[:2]]
        self.assertEqual([Path(p).name for p in shown], ["left_side_mask.exr", "right_mask.exr"])

    def test_uvs_in_tiles_are_one_tiled_image(self):
        mesh, right, uv = halves()
        uv[:, 0] += np.repeat(right, 4)
        mesh.uv_layers.active.data.foreach_set("uv", uv.reshape(-1))
        self.crack(meshes.link(mesh))
        made = self.bake(size=16, directory=str(self.folder))
        image = image_of(made.data.materials[0], "mask")
        self.assertEqual(image.source, "TILED")
        self.assertEqual(sorted(t.number for t in image.tiles), [1001, 1002])
        self.assertTrue((self.folder / "mask.1002.exr").is_file())

    def test_what_is_amiss_is_one_sentence(self):
        made = self.crack(meshes.link(meshes.grid(8)))
        (self.folder / "file").write_text("")
        for directory, words in (
            ("//maps", "never saved"), (str(self.folder / "file"), "file: File exists"),
        ):  # fmt: skip
            with self.assertRaisesRegex(RuntimeError, f"^Error: craze: .*{words}"):
                bpy.ops.craze.bake(size=16, directory=directory)
        mesh = meshes.grid(8)
        mesh.uv_layers.remove(mesh.uv_layers[0])
        self.crack(meshes.link(mesh))
        with self.assertRaisesRegex(RuntimeError, "no UVs"):
            bpy.ops.craze.bake(size=16)
        self.assertNotIn(crack_nodes.GROUP, bpy.data.node_groups)
        self.assertEqual(len(made.data.materials), 2)

    def test_the_render_is_dark_in_cracks_and_as_before_far_from_them(self):
        """What Cycles shows of a flat white plate, seen from above, in even light."""
        made = self.crack(meshes.link(meshes.grid(8, size=0.5)), recipe=self.recipe.replace("wall = 0.03", "wall = 0"))
        self.bake(size=256)
        material = made.data.materials[0]
        group = group_of(material)
        group.inputs["Color"].default_value = (1, 1, 1, 1)
        emission = material.node_tree.nodes.new("ShaderNodeEmission")
        links = material.node_tree.links
        links.new(group.outputs["Color"], emission.inputs["Color"])
        output = material.node_tree.nodes["Material Output"]
        links.new(emission.outputs[0], output.inputs["Surface"])
        far = pixels(image_of(material, "distance")).max()
        self.assertAlmostEqual(group.inputs["Stain Reach"].default_value, far / 4, places=6)
        seen = _from_above()
        self.assertLess(seen.min(), 0.1)
        self.assertGreater(seen.max(), 0.95)


def _from_above():
    """(64, 64) of a square of 1 × 1 in the middle, linear red."""
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.samples = "CYCLES", 1
    scene.cycles.use_denoising = False
    scene.render.resolution_x = scene.render.resolution_y = 64
    scene.view_settings.view_transform = "Raw"
    camera = bpy.data.cameras.new("above")
    camera.type, camera.ortho_scale = "ORTHO", 1.0
    holder = bpy.data.objects.new("above", camera)
    holder.location = (0, 0, 2)
    scene.collection.objects.link(holder)
    scene.camera = holder
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = f"{folder}/seen.exr"
        scene.render.image_settings.file_format = "OPEN_EXR"
        bpy.ops.render.render(write_still=True)
        seen = bpy.data.images.load(scene.render.filepath)
        return pixels(seen)


