"""Objects that are not as one would like them, and what happens to them meanwhile."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import bpy
import meshes
import numpy as np
from cracking import Cracking, get, places, recipe_of

from craze_blender import cracked, live, process
from craze_blender.operators.crack import CRAZE_OT_crack
from craze_blender.work import Work

COMMAND = os.environ.get("CRAZE_COMMAND", "")


def world(thing):
    """(n, 3): the vertices of a mesh, or points of a curve, in the scene."""
    bpy.context.view_layer.update()
    if thing.type == "MESH":
        here = places(thing.data)
    else:
        here = np.array([p.co[:3] for s in thing.data.splines for p in s.points])
    matrix = np.array(thing.matrix_world)
    return here @ matrix[:3, :3].T + matrix[:3, 3]


def rounded(points):
    return {tuple(p) for p in (np.round(points, 3) + 0.0).tolist()}


class OddObjects(Cracking):
    recipe = recipe_of("relative_spacing = 0.2")

    def test_an_object_without_extent_along_an_axis_is_refused(self):
        for scale in ((1, 1, 0), (0, 0, 0), (1, 1e-7, 1)):
            thing = meshes.link(meshes.grid(8))
            thing.scale = scale
            bpy.context.view_layer.update()
            with self.assertRaisesRegex(RuntimeError, "scaled to nothing"):
                self.crack(thing)
        self.assertEqual(len(bpy.data.meshes), 3)

    def test_pieces_and_curves_of_a_sheared_object_are_where_it_is(self):
        holder = bpy.data.objects.new("holder", None)
        bpy.context.scene.collection.objects.link(holder)
        holder.scale, holder.location = (2, 1, -1), (1, 2, 3)
        thing = meshes.link(meshes.grid(10))
        thing.parent, thing.rotation_euler = holder, (0.2, 0.3, 0.7)
        bpy.context.view_layer.update()
        new = self.crack(thing, recipe=self.recipe.replace("gap = 0.1", "gap = 0.0"))
        whole = rounded(world(new))
        self.assertEqual(bpy.ops.craze.curves(), {"FINISHED"})
        self.assertLessEqual(rounded(world(bpy.context.active_object)), whole)
        meshes.activate(new)
        self.assertEqual(bpy.ops.craze.pieces(thickness=0), {"FINISHED"})
        pieces = [o for o in bpy.data.objects if " fragment " in o.name]
        self.assertEqual(set().union(*(rounded(world(p)) for p in pieces)), whole)

    def test_a_group_of_any_name_says_where(self):
        thing = meshes.link(meshes.grid(12))
        name = 'где "x"\\'
        group = thing.vertex_groups.new(name=name)
        for vertex in thing.data.vertices:
            group.add([vertex.index], float(vertex.co.x > 0), "REPLACE")
        recipe = self.recipe + f"where.attribute = {json.dumps(name, ensure_ascii=False)}\n"
        new = self.crack(thing, recipe=recipe)
        distance = get(new.data.attributes["crack_distance"].data, "value")[:, 0]
        self.assertGreater(places(new.data)[distance < 1e-9, 0].min(), -0.15)

    def test_of_a_linked_collection_it_comes_to_the_scene(self):
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "library.blend")
            collection = bpy.data.collections.new("linked")
            collection.objects.link(bpy.data.objects.new("far", meshes.grid(8)))
            bpy.data.libraries.write(path, {collection}, fake_user=True)
            meshes.empty()
            with bpy.data.libraries.load(path, link=True) as (_, wanted):
                wanted.collections = ["linked"]
            [linked] = wanted.collections
            bpy.context.scene.collection.children.link(linked)
            new = self.crack_linked(linked.objects[0])
            bpy.data.libraries.remove(linked.library)
            self.assertGreater(len(new.data.vertices), 81)

    def crack_linked(self, thing):
        bpy.context.view_layer.objects.active = thing
        self.assertEqual(bpy.ops.craze.crack(recipe=self.recipe), {"FINISHED"})
        new = bpy.context.active_object
        self.assertEqual(new.name, "far cracked")
        self.assertEqual(list(new.users_collection), [bpy.context.scene.collection])
        return new

    def test_what_is_removed_meanwhile_leaves_nothing(self):
        thing = meshes.link(meshes.grid(8))
        before = len(bpy.data.meshes)
        work = self.started(thing)
        bpy.data.objects.remove(thing)
        work.finish()
        self.assertEqual(work.state, "failed")
        self.assertIn("removed", work.error)
        self.assertEqual(len(bpy.data.meshes), before)

    def test_another_mesh_comes_when_edit_mode_is_left(self):
        thing = self.crack(meshes.link(meshes.grid(8)), in_place=True)
        shape = places(thing.data)
        work = self.started(thing)
        bpy.ops.object.mode_set(mode="EDIT")
        while work.says()[0] != "waiting until Edit Mode is left":
            work.advance(0.01)
        bpy.ops.object.mode_set(mode="OBJECT")
        np.testing.assert_array_equal(places(thing.data), shape)
        work.finish()
        self.assertEqual(work.state, "done", work.error)
        self.assertFalse(np.array_equal(places(thing.data), shape))
        self.assertEqual(len(bpy.data.meshes), 3)

    def started(self, thing):
        """What bpy.ops.craze.crack() does with another seed, begun."""

        class Said(CRAZE_OT_crack.__mro__[1], CRAZE_OT_crack.__mro__[2]):
            preset, seed, spacing, recipe = "", 5, 0.0, self.recipe
            steps, _in_place = CRAZE_OT_crack.steps, lambda *_: False
            report = print

        work = Work(process.engine(), Said().steps(bpy.context))
        work.advance(0.0)
        return work

    def test_a_copy_of_an_animated_object_grows_by_an_action_of_its_own(self):
        thing = meshes.link(meshes.grid(8))
        thing.keyframe_insert("location", frame=1)
        thing.shape_key_add(name="Basis")
        key = thing.shape_key_add(name="smile")
        key.keyframe_insert("value", frame=1)
        mute = thing.data.shape_keys.driver_add('key_blocks["smile"].mute').driver
        mute.expression = "frame > 7"
        for method in ("NODES", "KEYS"):
            meshes.activate(thing)
            thing.hide_set(False)
            new = self.crack(thing)
            self.assertEqual(bpy.ops.craze.grow(frames=4, method=method), {"FINISHED"})
            own = new.data.shape_keys.animation_data
            self.assertEqual([d.driver.expression for d in own.drivers], ["frame > 7"])
            self.assertEqual(len(own.action.fcurves), 1 if method == "NODES" else 5)
            [smile] = [c for c in own.action.fcurves if "smile" in c.data_path]
            self.assertEqual(smile.keyframe_points[0].interpolation, "BEZIER")
        self.assertEqual(len(thing.animation_data.action.fcurves), 3)
        self.assertEqual(len(thing.data.shape_keys.animation_data.action.fcurves), 1)

    def test_grow_opens_shut_cracks_where_it_is_told_and_refuses_none(self):
        shut = self.recipe.replace("gap = 0.1", "gap = 0.0")
        thing = self.crack(meshes.link(meshes.grid(8)), recipe=shut)
        with self.assertRaisesRegex(RuntimeError, r"shut.*grow\(gap=0.1\)"):
            bpy.ops.craze.grow(frames=4)
        self.assertEqual(bpy.ops.craze.grow(frames=4, gap=0.1), {"FINISHED"})
        self.assertEqual(cracked.post_of(thing)["gap"], 0.1)
        opened = places(thing.data)
        wanted = self.crack(meshes.link(meshes.grid(8)))
        np.testing.assert_array_equal(opened, places(wanted.data))
        whole = self.crack(meshes.link(meshes.grid(8)), recipe=self.recipe.replace("2.0", "0.01"))
        for operator in (bpy.ops.craze.grow, bpy.ops.craze.curves):
            meshes.activate(whole)
            with self.assertRaisesRegex(RuntimeError, "there are no cracks"):
                operator()

    def test_another_file_ends_what_follows_the_sliders(self):
        thing = self.crack(meshes.link(meshes.grid(8)))
        live._Wish.do, live._Wish.thing = "crack", thing.name
        live._Wish.work = work = live.start(thing, "crack", bpy.context.scene)
        work.advance(0.0)
        bpy.ops.wm.read_homefile(use_factory_startup=True)
        self.assertIsNone(live._Wish.do)
        self.assertIsNone(live._Wish.work)
        self.assertEqual(work.state, "cancelled")

    def test_a_wrong_context_is_said(self):
        bpy.context.view_layer.objects.active = None
        with self.assertRaisesRegex(RuntimeError, "select a mesh, in Object Mode"):
            bpy.ops.craze.crack()
        meshes.link(meshes.grid(4))
        with self.assertRaisesRegex(RuntimeError, "that Crack has made"):
            bpy.ops.craze.bake()

    def test_recipes_are_not_written_anywhere(self):
        meshes.link(meshes.grid(4))
        for path, words in (("", "filepath="), ("//r.toml", "never saved"),
                            ("/nowhere/at/all.toml", "No such file")):  # fmt: skip
            with self.assertRaisesRegex(RuntimeError, words):
                bpy.ops.craze.export_recipe(filepath=path)

    @unittest.skipUnless(COMMAND, "without the command")
    def test_a_recipe_that_was_exported_gives_the_command_the_same_cracks(self):
        """The seed is that of the operator, else the panel's, and a hit is where it was."""
        panel = bpy.context.scene.craze
        panel.preset, panel.keys.seed = "glass-impact", 77
        panel.keys.impact[0].point = (4.03, 0.02, 0.0)
        panel.keys.layer_spacing = 0.1
        for said, seed in (({}, 77), ({"preset": "mud", "seed": 11, "spacing": 0.3}, 11)):
            with self.subTest(seed=seed), tempfile.TemporaryDirectory() as folder:
                self.same_as_the_command(Path(folder), said, seed)
        panel.keys.impact.clear()
        panel.preset, panel.keys.seed, panel.keys.layer_spacing = "mud", 1, 0.0

    def same_as_the_command(self, folder, said, seed):
        import test_same_bytes

        thing = meshes.link(meshes.grid(8, size=0.5))
        thing.location.x = 4
        bpy.context.view_layer.update()
        given, recipe, out = folder / "in.ply", folder / "r.toml", folder / "out.ply"
        test_same_bytes.write(given, thing.data)
        if not said:  # before it is cracked: the panel's
            bpy.ops.craze.export_recipe(filepath=str(recipe))
        bpy.ops.craze.crack(**said)
        new = bpy.context.active_object
        if said:
            bpy.ops.craze.export_recipe(filepath=str(recipe))
        self.assertIn(f"\nseed = {seed}\n", "\n" + recipe.read_text())
        subprocess.run([COMMAND, "crack", given, "--recipe", recipe, "--quiet", "-o", out],
                       check=True)  # fmt: skip
        vertex = test_same_bytes.ply(out)["vertex"]
        theirs = np.stack([vertex[k] for k in "xyz"], axis=1).astype(np.float32)
        self.assertEqual(places(new.data).tobytes(), theirs.tobytes())
        self.assertGreater(len(theirs), 200)
