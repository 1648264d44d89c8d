"""What a user does to an object while it cracks, or to a cracked one, is not lost."""

import collections
import subprocess
import tempfile
from pathlib import Path

import bmesh
import bpy
import meshes
from cracking import Cracking, places, recipe_of

from craze_blender import changes, live, nodes, process, work, world
from craze_blender.operators.crack import CRAZE_OT_crack
from craze_blender.work import Work

RECIPE = recipe_of("relative_spacing = 0.2")

# In a Blender that opens a file, with the add-on.
AFTER = """
import bpy, craze_blender
craze_blender.register()
bpy.ops.wm.open_mainfile(filepath=bpy.data.filepath)
print([o.name for o in bpy.data.objects], [m.name for m in bpy.data.meshes])
craze_blender.unregister()
"""


def steps_to_end(steps):
    """What a generator returns."""
    while True:
        try:
            next(steps)
        except StopIteration as e:
            return e.value


def digest(thing):
    mesh = thing.data.copy()
    try:
        return steps_to_end(changes.digest(mesh, len(thing.vertex_groups)))
    finally:
        bpy.data.meshes.remove(mesh)


def move(thing):
    thing.data.vertices[0].co.z += 1


def weigh(thing):
    thing.vertex_groups[0].add([3], 0.123, "REPLACE")


def unwrap(thing):
    thing.data.uv_layers[0].data[5].uv.x += 0.25


def paint(thing):
    thing.data.attributes["crack_time"].data[7].value = 5.5


def seam(thing):
    thing.data.edges[2].use_seam = not thing.data.edges[2].use_seam


def assign(thing):
    thing.data.polygons[1].material_index += 1


def turn(thing):
    thing.data.flip_normals()


def delete(thing):
    shape = bmesh.new()
    shape.from_mesh(thing.data)
    bmesh.ops.delete(shape, geom=[list(shape.faces)[-1]], context="FACES")
    shape.to_mesh(thing.data)
    shape.free()


def key(thing):
    thing.shape_key_add(name="mine", from_mix=False)


def purge():
    for mesh in [m for m in bpy.data.meshes if m.users == 0]:
        bpy.data.meshes.remove(mesh)


class Changes(Cracking):
    recipe = RECIPE

    def thing(self, n=8):
        thing = meshes.link(meshes.grid(n))
        thing.vertex_groups.new(name="bone").add(range(9), 0.5, "REPLACE")
        return thing

    def test_a_digest_tells_what_a_user_can_change(self):
        thing = self.crack(self.thing())
        for change in (move, weigh, unwrap, paint, seam, assign, turn, delete, key):
            with self.subTest(change=change.__name__):
                before = digest(thing)
                self.assertEqual(digest(thing), before)
                change(thing)
                self.assertNotEqual(digest(thing), before)

    def test_a_look_into_edit_mode_is_no_change(self):
        for seed in range(6):
            thing = meshes.link(meshes.grid(8))
            meshes.dress(thing, seed)
            new = self.crack(thing)
            before = digest(new)
            for mode in ("EDIT", "SCULPT", "WEIGHT_PAINT", "OBJECT"):
                bpy.ops.object.mode_set(mode=mode)
            self.assertEqual(digest(new), before, seed)
            self.assertFalse(steps_to_end(changes.edited(new)))

    def started(self, in_place):
        """What bpy.ops.craze.crack() does with the active object and another seed, begun."""
        said = []

        class Said(CRAZE_OT_crack.__mro__[1], CRAZE_OT_crack.__mro__[2]):
            preset, seed, spacing, recipe = "", 5, 0.0, self.recipe
            steps, _in_place = CRAZE_OT_crack.steps, lambda *_: in_place

            def report(self, _, sentence):
                said.extend([sentence] if "by hand" in sentence else [])

        going = Work(process.engine(), Said().steps(bpy.context))
        going.advance(0.0)
        going.said = said
        return going

    def test_an_object_that_is_changed_while_it_cracks_in_place_keeps_its_change(self):
        for change in (move, weigh, unwrap, key):
            with self.subTest(change=change.__name__):
                meshes.empty()
                thing = self.thing()
                before = len(bpy.data.meshes)
                going = self.started(in_place=True)
                change(thing)
                mine, shape = digest(thing), places(thing.data)
                going.finish()
                self.assertEqual(going.state, "done", going.error)
                self.assertEqual(digest(thing), mine)
                self.assertFalse(thing.hide_get())
                new = bpy.data.objects["thing cracked"]
                self.assertGreater(len(new.data.vertices), len(shape))
                self.assertEqual(going.said, ["craze: thing was changed by hand and stays; "
                                             "the cracks are in thing cracked"])  # fmt: skip
                self.assertEqual(len(bpy.data.meshes), before + 2)
                self.assertIs(bpy.context.active_object, thing)

    def test_so_does_one_with_modifiers(self):
        def subdivide(thing):
            thing.modifiers["mine"].levels = 2

        def another(thing):
            thing.modifiers.new("bend", "SIMPLE_DEFORM")

        for change in (move, subdivide, another, None):
            with self.subTest(change=change and change.__name__):
                meshes.empty()
                thing = self.thing()
                thing.modifiers.new("mine", "SUBSURF").levels = 1
                going = self.started(in_place=True)
                if change:
                    change(thing)
                mine, names = digest(thing), [m.name for m in thing.modifiers]
                going.finish()
                self.assertEqual(going.state, "done", going.error)
                if change:
                    self.assertEqual(digest(thing), mine)
                    self.assertEqual([m.name for m in thing.modifiers], names)
                    self.assertEqual([*bpy.data.objects["thing cracked"].modifiers], [])
                else:
                    self.assertNotEqual(digest(thing), mine)
                    self.assertEqual(len(bpy.data.objects), 1)
                    self.assertEqual(going.said, [])
                self.assertEqual(len(bpy.data.meshes), 3)

    def test_inputs_of_nodes_count(self):
        tree = bpy.data.node_groups.new("nodes", "GeometryNodeTree")
        for kind in ("Geometry", "Vector", "Object"):
            nodes.new_socket(tree, "INPUT", kind, f"NodeSocket{kind}")
        nodes.new_socket(tree, "OUTPUT", "Geometry", "NodeSocketGeometry")
        ends = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
        tree.links.new(ends[0].outputs[0], ends[1].inputs[0])
        thing = self.thing()
        modifier = thing.modifiers.new("mine", "NODES")
        modifier.node_group = tree
        key = next(k for k in modifier.keys() if hasattr(modifier[k], "to_list"))
        for change in (False, True):
            before = changes.Before(thing, thing.data)
            if change:
                modifier[key] = (1.0, 2.0, 3.0)
            self.assertEqual(steps_to_end(before.changed(thing)), change)
            world.remove(before.kept())

    def test_a_cracked_object_that_was_changed_stays_when_it_is_cracked_anew_or_grows(self):
        for method in ("crack", "NODES", "KEYS"):
            for change in (move, weigh, unwrap, seam, delete):
                with self.subTest(method=method, change=change.__name__):
                    meshes.empty()
                    thing = self.crack(self.thing())
                    change(thing)
                    mine = digest(thing)
                    if method == "crack":
                        bpy.ops.craze.crack(recipe=RECIPE, seed=4)
                    else:
                        bpy.ops.craze.grow(frames=4, method=method)
                    self.assertEqual(digest(thing), mine)
                    new = bpy.data.objects["thing cracked.001"]
                    self.assertTrue(thing.hide_get())
                    self.assertIs(bpy.context.active_object, new)
                    self.assertNotEqual(digest(new), mine)
                    self.assertFalse(steps_to_end(changes.edited(new)))

    def test_the_sliders_leave_a_changed_one_alone_until_the_change_is_taken_back(self):
        thing = self.crack(self.thing())
        seam(thing)
        mine = digest(thing)
        for do in ("open", "crack"):
            self.assertFalse(thing.craze.edited and do == "open")
            going = live.start(thing, do, bpy.context.scene)
            going.finish()
            live.finish(thing, going)
            self.assertEqual(going.state, "done", going.error)
            self.assertEqual(digest(thing), mine)
            self.assertTrue(thing.craze.edited)
        seam(thing)
        going = live.start(thing, "crack", bpy.context.scene)
        going.finish()
        live.finish(thing, going)
        self.assertNotEqual(digest(thing), mine)
        self.assertFalse(thing.craze.edited)

    def test_no_shape_keys_are_left_of_what_was_compared(self):
        thing = self.thing()
        key(thing)
        self.crack(thing)
        before = len(bpy.data.shape_keys)
        for seed in range(3):
            bpy.ops.craze.crack(recipe=RECIPE, seed=seed)
        self.assertEqual(len(bpy.data.shape_keys), before)

    def test_what_is_changed_while_the_sliders_are_followed_stays(self):
        thing = self.crack(self.thing())
        before = len(bpy.data.meshes)
        going = live.start(thing, "crack", bpy.context.scene)
        while going.request is None:
            going.advance(0.0)
        move(thing)
        mine = digest(thing)
        going.finish()
        live.finish(thing, going)
        self.assertEqual(digest(thing), mine)
        self.assertEqual(len(bpy.data.meshes), before)

    def test_grown_and_baked_ones_are_not_changed_by_hand(self):
        for grow in ({"method": "KEYS"}, {"method": "NODES"}):
            thing = self.crack(self.thing())
            bpy.ops.craze.grow(frames=4, **grow)
            bpy.ops.craze.bake(size=16)
            self.assertFalse(steps_to_end(changes.edited(thing)), grow)

    def test_an_object_that_has_the_name_keeps_it(self):
        for name in ("thing", "x" * 63, "ы" * 31):
            thing = self.thing()
            thing.name = name
            first = self.crack(thing)
            name = first.name
            self.assertTrue(name.startswith(thing.name[:20]))
            second = self.crack(thing)
            self.assertEqual(first.name, name)
            self.assertNotEqual(second.name, name)

    def test_groups_that_were_removed_since_do_not_shift_the_others(self):
        thing = self.thing()
        thing.vertex_groups.new(name="second").add(range(20, 30), 1.0, "REPLACE")
        new = self.crack(thing)
        first = digest(new)
        new.vertex_groups.remove(new.vertex_groups["bone"])
        bpy.ops.craze.crack(recipe=RECIPE)
        again = bpy.data.objects["thing cracked.001"]
        self.assertEqual([g.name for g in again.vertex_groups], ["bone", "second"])
        self.assertEqual(digest(again), first)

    def test_a_work_that_is_stopped_at_any_step_leaves_no_mesh(self):
        for in_place, modifier in ((True, False), (True, True), (False, False)):
            meshes.empty()
            thing = self.thing()
            key(thing)
            keys = len(bpy.data.shape_keys)
            if modifier:
                thing.modifiers.new("mine", "SUBSURF").levels = 1
            before, count = len(bpy.data.meshes), 1
            while True:
                going = self.started(in_place)
                for _ in range(count):
                    while not going.advance(0.0) and going.request is not None:
                        if going.request.state != "running":
                            break
                if going.state != "running":
                    break
                going.cancel()
                self.assertEqual(len(bpy.data.meshes), before, count)
                self.assertEqual(len(bpy.data.shape_keys), keys, count)
                count += 4
            self.assertGreater(count, 10)



    def test_what_is_taken_away_between_two_steps_is_one_sentence(self):
        """Purged, as an undo does it too: parts of data-blocks that are gone are not touched."""
        ended = self.interrupted(purge, range(1, 200, 7))
        self.assertEqual(ended.keys(), {"", work.GONE})
        self.assertGreater(ended[work.GONE], 10)

    def test_an_undo_while_a_mesh_is_made_ends_it(self):
        """That mesh may have gone back to what it was half made."""
        ended = self.interrupted(lambda: work._undo(None), range(1, 200, 7))
        self.assertEqual(ended.keys(), {"", work.GONE})
        self.assertGreater(ended[work.GONE], 10)

    def interrupted(self, by, steps):
        """How often a run ends with which error, where something happens after so many steps."""
        ended = collections.Counter()
        for step in steps:
            meshes.empty()
            thing = self.thing()
            meshes.dress(thing, 3)
            going, done = self.started(in_place=False), 0
            while not going.advance(0.0):
                if going.request is None:
                    done += 1
                    if done == step:
                        by()
            ended[going.error] += 1
            self.assertEqual(len(bpy.data.meshes), 1 if going.error else 3)
        return ended

    def test_a_file_saved_meanwhile_has_nothing_of_the_run(self):
        for keys in (False, True):
            meshes.empty()
            thing = self.thing()
            if keys:
                thing.shape_key_add(name="Basis")
                thing.shape_key_add(name="mine")
            going = self.started(in_place=False)
            with tempfile.TemporaryDirectory() as folder:
                path = str(Path(folder) / "meanwhile.blend")
                bpy.ops.wm.save_as_mainfile(filepath=path, copy=True)
                self.assertEqual(len(bpy.data.objects), 1)
                going.finish()
                self.assertEqual(going.state, "done", going.error)
                said = subprocess.run(
                    [bpy.app.binary_path, "-b", "--factory-startup", path, "--python-use-system-env",
                     "--python-exit-code", "3", "--python-expr", AFTER], text=True,
                    capture_output=True, check=True,
                )  # fmt: skip
                self.assertIn("['thing'] ['grid']", said.stdout)
                self.assertNotIn("Error", said.stdout + said.stderr)
