"""Objects that are hidden, scaled since, selected with others, or of another file."""

import json
import tempfile
from pathlib import Path

import bpy
import meshes
from cracking import Cracking, places, recipe_of

from craze_blender import live

RECIPE = recipe_of("spacing = 0.5")


def length(thing):
    """Of its cracks, in the scene."""
    return json.loads(thing.craze.report)["cracks"]["length"]


class WhereItIs(Cracking):
    recipe = RECIPE

    def subdivided(self):
        thing = meshes.link(meshes.grid(6))
        thing.modifiers.new("finer", "SUBSURF").levels = 2
        return thing

    def test_modifiers_of_an_object_that_is_hidden_are_applied(self):
        wanted = len(self.crack(self.subdivided()).data.vertices)
        for in_place in (False, True):
            thing = self.subdivided()
            thing.hide_viewport = True
            bpy.ops.craze.crack(recipe=RECIPE, in_place=in_place)
            found = thing if in_place else bpy.context.active_object
            self.assertEqual(len(found.data.vertices), wanted)

    def test_a_result_is_in_renders_though_its_object_was_hidden_before(self):
        thing = meshes.link(meshes.grid(8))
        bpy.data.objects.remove(self.crack(thing))
        thing.hide_set(False)
        self.assertTrue(thing.hide_render)
        self.assertFalse(self.crack(thing).hide_render)

    def test_a_cracked_object_that_was_scaled_since_cracks_anew_at_its_size(self):
        thing = self.crack(meshes.link(meshes.grid(12)))
        thing.scale = (3, 3, 3)
        bpy.context.view_layer.update()
        wide = meshes.link(meshes.grid(12, size=3.0))
        wanted = length(self.crack(wide))
        meshes.activate(thing)
        bpy.ops.craze.crack(recipe=RECIPE)
        self.assertAlmostEqual(length(thing), wanted, places=4)
        bpy.ops.craze.curves()  # as the run has it
        curve = bpy.context.active_object.data
        self.assertLess(max(p.co.x for s in curve.splines for p in s.points), 1.001)

    def test_so_it_follows_the_sliders(self):
        panel = bpy.context.scene.craze
        panel.preset, panel.keys.layer_spacing = "mud", 0.5
        thing = self.crack(meshes.link(meshes.grid(12)), recipe="")
        wanted = length(self.crack(meshes.link(meshes.grid(12, size=2.0)), recipe=""))
        thing.scale = (2, 2, 2)
        bpy.context.view_layer.update()
        going = live.start(thing, "crack", bpy.context.scene)
        going.finish()
        live.finish(thing, going)
        self.assertAlmostEqual(length(thing), wanted, places=4)
        panel.keys.layer_spacing = 0.0

    def test_of_several_selected_objects_the_active_one_cracks(self):
        other = meshes.link(meshes.grid(8), "other")
        thing = meshes.link(meshes.grid(8))
        other.select_set(True)
        bpy.ops.craze.crack(recipe=RECIPE)
        self.assertEqual(
            sorted(o.name for o in bpy.data.objects), ["other", "thing", "thing cracked"]
        )

    def test_what_is_cracked_is_not_painted_on(self):
        self.crack(meshes.link(meshes.grid(8)))
        with self.assertRaisesRegex(RuntimeError, "paint on what this was cracked from"):
            bpy.ops.craze.paint()

    def test_a_group_that_is_not_there_is_said_with_those_that_are(self):
        keys = bpy.context.scene.craze.keys
        thing = meshes.link(meshes.grid(8))
        keys.where_attribute = "Crakcs"
        try:
            for groups in ("none", "Cracks, other"):
                with self.assertRaisesRegex(
                    RuntimeError, rf"no vertex group or attribute Crakcs.*groups: {groups}\n"
                ):
                    bpy.ops.craze.crack()
                thing.vertex_groups.new(name="Cracks")
                thing.vertex_groups.new(name="other")
            self.assertEqual(len(bpy.data.meshes), 1)
        finally:
            keys.where_attribute = ""

    def linked(self, cracked, override):
        """An object as it comes from another file."""
        with tempfile.TemporaryDirectory() as folder:
            meshes.empty()
            path = str(Path(folder) / "library.blend")
            collection = bpy.data.collections.new("linked")
            thing = meshes.link(meshes.grid(8), "far")
            if cracked:
                thing = self.crack(thing)
            collection.objects.link(thing)
            name = collection.name
            bpy.data.libraries.write(path, {collection}, fake_user=True)
            meshes.empty()
            with bpy.data.libraries.load(path, link=True) as (_, wanted):
                wanted.collections = [name]
            [found] = wanted.collections
            bpy.context.scene.collection.children.link(found)
            if override:
                found.override_hierarchy_create(bpy.context.scene, bpy.context.view_layer)
            [thing] = [o for o in bpy.data.objects
                       if (o.override_library if override else o.library)]  # fmt: skip
            bpy.context.view_layer.objects.active = thing
            yield thing
            meshes.empty()
            for library in list(bpy.data.libraries):
                bpy.data.libraries.remove(library)

    def test_what_would_be_lost_with_the_next_reading_is_refused(self):
        for override in (False, True):
            for thing in self.linked(False, override):
                before = places(thing.data).tobytes(), len(bpy.data.meshes)
                with self.assertRaisesRegex(RuntimeError, "far belongs to another file"):
                    bpy.ops.craze.crack(recipe=RECIPE, in_place=True)
                self.assertEqual((places(thing.data).tobytes(), len(bpy.data.meshes)), before)
                self.assertEqual(bpy.ops.craze.crack(recipe=RECIPE), {"FINISHED"})
            for thing in self.linked(True, override):
                for operator in (bpy.ops.craze.crack, bpy.ops.craze.grow, bpy.ops.craze.bake):
                    with self.assertRaisesRegex(RuntimeError, "belongs to another file"):
                        operator()
                self.assertEqual(bpy.ops.craze.pieces(), {"FINISHED"})
