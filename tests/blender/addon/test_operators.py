"""Each operator, without a window."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import bmesh
import bpy
import meshes
import numpy as np
from cracking import Cracking, places
from mathutils import Vector

from craze_blender import mesh_in, process, table
from craze_blender.operators import curves, pieces

COMMAND = os.environ.get("CRAZE_COMMAND", "")
RECIPE = """
mesh.edge = "keep"
material = { criterion = "strength", scatter = 0.15 }
layer.relative_spacing = 0.12
evolution.max_load = 2.0
"""
OPEN = RECIPE + "post = { gap = 0.1, wall = 0.05 }\n"


class Operators(Cracking):
    recipe = RECIPE

    def test_crack_makes_an_object_beside_and_hides_the_other(self):
        thing = meshes.link(meshes.grid(12))
        shape = places(thing.data).tobytes()
        new = self.crack(thing)
        self.assertIsNot(new, thing)
        self.assertEqual(new.users_collection, thing.users_collection)
        self.assertTrue(thing.hide_get() and thing.hide_render)
        self.assertEqual(places(thing.data).tobytes(), shape)

    def test_crack_in_place_keeps_the_object_and_what_it_was(self):
        thing = meshes.link(meshes.grid(12))
        shape = places(thing.data).tobytes()
        self.assertIs(self.crack(thing, in_place=True), thing)
        self.assertGreater(len(thing.data.vertices), len(thing.craze.mesh.vertices))
        self.assertEqual(places(thing.craze.mesh).tobytes(), shape)
        # Again: from what it was, not from the cracked mesh.
        first = places(thing.data).tobytes()
        self.crack(thing, seed=99)
        self.assertNotEqual(places(thing.data).tobytes(), first)
        self.crack(thing)
        self.assertEqual(places(thing.data).tobytes(), first)

    def test_scale_counts_and_the_rest_of_the_matrix_does_not(self):
        """A turned, moved or mirrored object cracks as one that is not; a stretched one as the
        mesh that it looks like."""
        plain = places(self.crack(meshes.link(meshes.grid(12))).data)
        for rotation, location, scale in (
            ((0.3, 0.7, -2.0), (5, 6, 7), (1, 1, 1)),
            ((1.0, 0.0, 0.4), (0, 0, 0), (-1, 1, 1)),
        ):
            thing = meshes.link(meshes.grid(12))
            thing.rotation_euler, thing.location, thing.scale = rotation, location, scale
            bpy.context.view_layer.update()
            np.testing.assert_array_equal(places(self.crack(thing).data), plain)
        thing = meshes.link(meshes.grid(12))
        thing.scale = (2, 1, 1)
        bpy.context.view_layer.update()
        stretched = places(self.crack(thing).data)
        mesh = meshes.grid(12)
        for vertex in mesh.vertices:
            vertex.co.x *= 2
        looks = places(self.crack(meshes.link(mesh)).data)
        np.testing.assert_allclose(stretched * (2, 1, 1), looks, atol=1e-6)

    def test_the_stretch_of_a_sheared_matrix_is_its_symmetric_part(self):
        from mathutils import Matrix

        matrix = Matrix(((1, 0.5, 0, 3), (0, 1, 0, 0), (0, 0, -2, 0), (0, 0, 0, 1)))
        stretch = mesh_in.stretch_of(matrix)
        linear = np.array(matrix.to_3x3())
        np.testing.assert_array_equal(stretch, stretch.T)
        np.testing.assert_allclose(stretch @ stretch, linear.T @ linear, atol=1e-4)
        self.assertGreater(np.linalg.eigvalsh(stretch).min(), 0)

    def test_a_group_keeps_cracks_away(self):
        thing = meshes.link(meshes.grid(24))
        group = thing.vertex_groups.new(name="where")
        for vertex in thing.data.vertices:
            group.add([vertex.index], 1.0 if vertex.co.x > 0 else 0.0, "REPLACE")
        new = self.crack(thing, recipe=RECIPE + 'layer.attribute = "where"\n')
        opened = [v.co.x for v in new.data.vertices if _on_a_crack(new.data, v.index)]
        self.assertTrue(opened)
        self.assertGreater(min(opened), -0.1)

    def test_pieces_are_the_fragments_with_their_layers_and_origins(self):
        thing = meshes.link(meshes.grid(14))
        meshes.dress(thing, 4)
        new = self.crack(thing)
        fragments = {d.value for d in new.data.attributes["fragment"].data}
        area = sum(p.area for p in new.data.polygons)
        self.assertEqual(bpy.ops.craze.pieces(thickness=0), {"FINISHED"})
        pieces = self.pieces()
        self.assertEqual(len(pieces), len(fragments))
        self.assertGreater(len(pieces), 3)
        self.assertAlmostEqual(sum(p.area for o in pieces for p in o.data.polygons), area, 4)
        for piece in pieces:
            self.assert_piece_of(new, piece)
        here = np.concatenate([places(o.data) + np.array(o.matrix_world.translation)
                               for o in pieces])  # fmt: skip
        whole = {tuple(np.round(p, 4)) for p in places(new.data).tolist()}
        self.assertEqual({tuple(np.round(p, 4)) for p in here.tolist()}, whole)

    def test_pieces_with_a_thickness_are_closed_solids_about_their_centres_of_mass(self):
        thing = meshes.link(meshes.grid(14))
        meshes.dress(thing, 4)
        new = self.crack(thing)
        fragments = {d.value for d in new.data.attributes["fragment"].data}
        area = sum(p.area for p in new.data.polygons)
        self.assertEqual(bpy.ops.craze.pieces(thickness=0.1), {"FINISHED"})
        pieces = self.pieces()
        self.assertEqual(len(pieces), len(fragments))
        total = 0.0
        for piece in pieces:
            self.assert_piece_of(new, piece)
            shape = bmesh.new()
            shape.from_mesh(piece.data)
            self.assertTrue(all(e.is_manifold for e in shape.edges), piece.name)
            bmesh.ops.triangulate(shape, faces=shape.faces[:])
            six = [f.verts[0].co.dot(f.verts[1].co.cross(f.verts[2].co)) for f in shape.faces]
            total += sum(six) / 6
            centre = sum((x * (f.verts[0].co + f.verts[1].co + f.verts[2].co) / 4
                          for x, f in zip(six, shape.faces)), Vector())  # fmt: skip
            self.assertLess(centre.length / sum(six), 1e-4)
            shape.free()
        self.assertAlmostEqual(total, 0.1 * area, 3)
        self.assertEqual(len([m for m in bpy.data.meshes if m.users == 0]), 0)

    def test_pieces_that_are_stopped_leave_nothing(self):
        new = self.crack(meshes.link(meshes.grid(14)))
        before = [len(d) for d in (bpy.data.objects, bpy.data.meshes, bpy.data.collections)]
        for steps in (0, 2, 10, 15):
            bodies = [pieces._Body(0.0, np.zeros(3), meshes.grid(1)) for _ in range(8)]
            going = pieces._gathered(bpy.context.scene, new, bodies, True)
            for _ in range(steps):
                next(going)
            going.close()
            if not steps:  # it never began
                bpy.data.batch_remove([body.mesh for body in bodies])
            if bpy.context.scene.rigidbody_world:
                bpy.ops.rigidbody.world_remove()
            for name in ("RigidBodyWorld", "RigidBodyConstraints"):
                if name in bpy.data.collections:
                    bpy.data.collections.remove(bpy.data.collections[name])
            after = [len(d) for d in (bpy.data.objects, bpy.data.meshes, bpy.data.collections)]
            self.assertEqual(after, before, f"after {steps} steps")

    def test_solid_pieces_fall_and_come_to_rest(self):
        thing = meshes.link(meshes.grid(14))
        thing.location = (0, 0, 0.5)
        bpy.context.view_layer.update()
        self.crack(thing, seed=3)
        self.assertEqual(bpy.ops.craze.pieces(thickness=0.1), {"FINISHED"})
        pieces = self.pieces()
        bpy.ops.mesh.primitive_cube_add(size=40, location=(0, 0, -20))
        bpy.ops.rigidbody.object_add(type="PASSIVE")
        floor = bpy.context.active_object
        floor.rigid_body.collision_shape = "BOX"
        scene = bpy.context.scene
        scene.rigidbody_world.point_cache.frame_end = 150
        graph = bpy.context.evaluated_depsgraph_get()
        before = start = None
        for frame in range(1, 151):
            scene.frame_set(frame)
            here = np.array([p.evaluated_get(graph).matrix_world.translation for p in pieces])
            start = here if start is None else start
            if before is not None:
                step = np.linalg.norm(here - before, axis=1).max() * scene.render.fps
                self.assertLess(step, 6.0, f"frame {frame}")  # m/s; from 0.5 m one falls at 3.1
            before, moved = here, None if before is None else np.abs(here - before).max()
        self.assertLess(moved, 1e-3)
        self.assertTrue((here[:, 2] < start[:, 2] - 0.2).all())
        self.assertTrue((here[:, 2] > 0).all())
        # Hulls of hollow pieces overlap at first, by less than a piece, and part. (In four of sixteen
        # patterns one is thrown farther, by up to 1.7 sizes.)
        size = max(max(p.dimensions) for p in pieces)
        aside = np.abs(here[:, :2] - start[:, :2]).max(axis=1)
        self.assertLess(np.median(aside), 0.75 * size)
        self.assertLess(aside.max(), size)

    def test_a_core_stays(self):
        bpy.ops.mesh.primitive_uv_sphere_add(segments=24, ring_count=16)
        self.crack(bpy.context.active_object)
        self.assertEqual(bpy.ops.craze.pieces(thickness=0.1, core=True), {"FINISHED"})
        still = [p for p in self.pieces() if p.rigid_body.type == "PASSIVE"]
        self.assertEqual(len(still), 1)
        self.assertAlmostEqual(max(still[0].dimensions) / 2, 0.9, 2)

    def pieces(self):
        return [o for o in bpy.data.objects if " fragment " in o.name]

    def assert_piece_of(self, new, piece):
        self.assertFalse(piece.data.validate())
        self.assertEqual({u.name for u in piece.data.uv_layers},
                         {u.name for u in new.data.uv_layers})  # fmt: skip
        self.assertEqual([g.name for g in piece.vertex_groups],
                         [g.name for g in new.vertex_groups])  # fmt: skip
        self.assertIsNotNone(piece.rigid_body)
        co = places(piece.data)
        self.assertTrue((co.min(axis=0) <= 1e-6).all() and (co.max(axis=0) >= -1e-6).all())

    def test_curves_are_as_wide_as_the_cracks_are_open(self):
        for gap, depth in ((0.0, 0.1), (0.05, 0.05), (0.2, 0.2)):
            self.crack(meshes.link(meshes.grid(12)), recipe=RECIPE + f"post.gap = {gap}\n")
            bpy.ops.craze.curves()
            self.assertAlmostEqual(bpy.context.active_object.data.bevel_depth, depth, places=6)

    def test_curves_have_the_cracks_length_and_half_their_width(self):
        new = self.crack(meshes.link(meshes.grid(12)))
        report = json.loads(new.craze.report)
        self.assertEqual(bpy.ops.craze.curves(), {"FINISHED"})
        made = bpy.context.active_object
        self.assertEqual(made.type, "CURVE")
        length = 0.0
        for spline in made.data.splines:
            co = np.array([p.co[:3] for p in spline.points])
            length += np.linalg.norm(np.diff(co, axis=0), axis=1).sum()
            self.assertTrue(all(p.radius >= 0 for p in spline.points))
        self.assertAlmostEqual(length, report["cracks"]["length"], places=3)
        self.assertTrue(any(p.radius > 0 for s in made.data.splines for p in s.points))

    def test_chains_use_each_edge_once(self):
        edges = np.array([[0, 1], [1, 2], [3, 2], [5, 6], [6, 7], [7, 5], [2, 4]])
        made = list(curves.chains(edges, np.array([0, 0, 0, 1, 1, 1, 2])))
        self.assertEqual(made[0], ([0, 1, 2, 3], [0, 1, 2]))
        self.assertEqual(sorted(e for _, along in made for e in along), list(range(7)))
        self.assertEqual({len(p) for p, _ in made}, {4, 2})

    def test_statistics_are_the_reports(self):
        new = self.crack(meshes.link(meshes.grid(12)))
        self.assertEqual(bpy.ops.craze.stats(), {"FINISHED"})
        text = bpy.data.texts[f"{new.name} statistics"].as_string()
        self.assertEqual(json.loads(text), json.loads(new.craze.report))

    @unittest.skipUnless(COMMAND, "without the command")
    def test_an_exported_recipe_is_one_for_the_command(self):
        new = self.crack(meshes.link(meshes.grid(12)), recipe=OPEN, seed=11)
        with tempfile.TemporaryDirectory() as folder:
            path, out = Path(folder) / "r.toml", Path(folder) / "out.json"
            self.assertEqual(bpy.ops.craze.export_recipe(filepath=str(path)), {"FINISHED"})
            subprocess.run(
                [COMMAND, "crack", "shape:plate?n=8", "--recipe", path, "--quiet",
                 "-o", Path(folder) / "o.ply", "--report", out], check=True,
            )  # fmt: skip
            theirs = json.loads(out.read_text())["recipe"]
        ours = json.loads(new.craze.recipe)
        self.assertEqual(theirs["seed"], 11)
        self.assertEqual(theirs["post"], ours["post"])
        self.assertEqual(theirs["material"], ours["material"])

    def test_a_saved_file_goes_on_where_it_was(self):
        new = self.crack(meshes.link(meshes.grid(12)), recipe=OPEN)
        name, shape = new.name, places(new.data).tobytes()
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "saved.blend")
            bpy.ops.wm.save_as_mainfile(filepath=path)
            process.stop()
            bpy.ops.wm.open_mainfile(filepath=path)
            new = bpy.data.objects[name]
            self.assertEqual(places(new.data).tobytes(), shape)
            self.assertIn("crack_distance", new.data.attributes)
            meshes.activate(new)
            self.assertEqual(bpy.ops.craze.grow(frames=4), {"FINISHED"})
            self.assertEqual(places(new.data).tobytes(), shape)
            self.assertEqual(bpy.ops.craze.pieces(), {"FINISHED"})

    def test_an_impact_is_where_the_cursor_is(self):
        thing = meshes.link(meshes.grid(12, size=0.3))
        thing.location = (4, 0, 0)
        bpy.context.view_layer.update()
        panel = bpy.context.scene.craze
        panel.preset = "glass-impact"
        panel.keys.impact.clear()
        bpy.context.scene.cursor.location = (4.125, 0.125, 0)
        bpy.ops.craze.impact()
        panel.keys.seed, panel.keys.post_gap = 1, 0.0
        meshes.activate(thing)
        self.assertEqual(bpy.ops.craze.crack(), {"FINISHED"})
        new = bpy.context.active_object
        self.assertEqual(json.loads(new.craze.recipe)["impact"][0]["point"], [0.125, 0.125, 0.0])
        panel.preset = "mud"

    def test_painting_where_makes_a_group_that_the_recipe_names(self):
        thing = meshes.link(meshes.grid(6))
        for polygon in thing.data.polygons:
            polygon.select = polygon.center.x > 0
        self.assertEqual(bpy.ops.craze.paint(selected=True), {"FINISHED"})
        group = thing.vertex_groups["Cracks"]
        found = {v.co.x >= -1e-6: group.weight(v.index) for v in thing.data.vertices}
        self.assertEqual(found, {True: 1.0, False: 0.0})
        keys = bpy.context.scene.craze.keys
        self.assertEqual(keys.where_attribute, "Cracks")
        keys.where_attribute = ""

    def test_faces_may_be_selected_in_edit_mode(self):
        thing = meshes.link(meshes.grid(6))
        for polygon in thing.data.polygons:
            polygon.select = False
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_mode(type="FACE")
        shape = bmesh.from_edit_mesh(thing.data)
        for face in shape.faces:
            face.select_set(face.calc_center_median().x > 0)
        self.assertEqual(bpy.ops.craze.paint(selected=True), {"FINISHED"})
        self.assertEqual(thing.mode, "EDIT")
        bpy.ops.object.mode_set(mode="OBJECT")
        group = thing.vertex_groups["Cracks"]
        found = {v.co.x >= -1e-6: group.weight(v.index) for v in thing.data.vertices}
        self.assertEqual(found, {True: 1.0, False: 0.0})
        bpy.context.scene.craze.keys.where_attribute = ""

    def test_what_shares_the_mesh_keeps_it(self):
        """Instances: objects of one mesh, and of a collection."""
        thing = meshes.link(meshes.grid(12))
        other = bpy.data.objects.new("other", thing.data)
        bpy.context.scene.collection.objects.link(other)
        other.location, other.scale = (3, 0, 0), (1, -2, 1)
        group = bpy.data.collections.new("group")
        group.objects.link(other)
        holder = bpy.data.objects.new("holder", None)
        holder.instance_type, holder.instance_collection = "COLLECTION", group
        bpy.context.scene.collection.objects.link(holder)
        shape, mesh = places(thing.data).tobytes(), thing.data
        self.crack(thing, in_place=True)
        self.assertIsNot(thing.data, mesh)
        self.assertIs(other.data, mesh)
        self.assertEqual(places(mesh).tobytes(), shape)
        bpy.context.view_layer.update()
        cracked = self.crack(other)
        self.assertEqual(len(cracked.data.vertices) > len(mesh.vertices), True)
        self.assertEqual(cracked.matrix_world, other.matrix_world)
        self.assertEqual(places(mesh).tobytes(), shape)

    def test_lengths_take_units_of_the_scene(self):
        text = RECIPE.replace("relative_spacing = 0.12", 'spacing = "400mm"')
        number = RECIPE.replace("relative_spacing = 0.12", "spacing = 0.4")
        first = places(self.crack(meshes.link(meshes.grid(12)), recipe=text).data)
        second = places(self.crack(meshes.link(meshes.grid(12)), recipe=number).data)
        np.testing.assert_array_equal(first, second)
        units = bpy.context.scene.unit_settings
        units.scale_length = 0.01
        try:
            text = text.replace("400mm", "4mm")
            third = places(self.crack(meshes.link(meshes.grid(12)), recipe=text).data)
        finally:
            units.scale_length = 1.0
        np.testing.assert_array_equal(third, second)

    def test_without_a_unit_system_a_unit_is_a_metre(self):
        """The unit scale does not count then, as nowhere in Blender."""
        units, thing = bpy.context.scene.unit_settings, meshes.link(meshes.grid(12))
        text = RECIPE.replace("relative_spacing = 0.12", 'spacing = "400mm"')
        wanted = places(self.crack(thing, recipe=text).data)
        units.system, units.scale_length = "NONE", 0.5
        try:
            found = places(self.crack(thing, recipe=text).data)
        finally:
            units.system, units.scale_length = "METRIC", 1.0
        np.testing.assert_array_equal(found, wanted)

    def test_the_panels_own_unit_stands(self):
        panel, thing = bpy.context.scene.craze, meshes.link(meshes.grid(12))
        panel.preset, panel.keys.layer_spacing = "mud", 0.4
        panel.keys.mesh_edge = "0.2"
        wanted = places(self.crack(thing, recipe="").data)
        panel.keys.mesh_edge, panel.keys.mesh_unit = "200mm", "mm"
        try:
            meshes.activate(thing)
            with self.assertRaisesRegex(RuntimeError, "mesh.edge"):
                bpy.ops.craze.crack()
            panel.keys.mesh_unit = "none"
            np.testing.assert_array_equal(places(self.crack(thing, recipe="").data), wanted)
        finally:
            panel.keys.mesh_edge, panel.keys.layer_spacing = "auto", 0.0
            panel.keys.mesh_unit = "none"

    def test_only_some_materials_crack(self):
        thing = meshes.link(meshes.grid(24))
        for name in ("glass", "paint"):
            thing.data.materials.append(bpy.data.materials.new(name))
        for polygon in thing.data.polygons:
            polygon.material_index = int(polygon.center.x > 0)
        panel = bpy.context.scene.craze
        panel.preset, panel.keys.where_materials = "mud", "pai*"
        panel.keys.post_gap = 0.0
        try:
            meshes.activate(thing)
            self.assertEqual(bpy.ops.craze.crack(), {"FINISHED"})
        finally:
            panel.keys.where_materials = ""
        new = bpy.context.active_object.data
        opened = [v.co.x for v in new.vertices if _on_a_crack(new, v.index)]
        self.assertGreater(min(opened), -1e-3)

    def test_every_key_of_the_table_is_a_property_with_its_help(self):
        properties = bpy.context.scene.craze.keys.bl_rna.properties
        for row in table.single():
            shown = properties[table.property_name(row["key"])]
            self.assertEqual(shown.description, row["help"])
            if row["type"] == "real" and row.get("maximum") is not None:
                self.assertAlmostEqual(shown.hard_max, row["maximum"])
        for section in table.repeated():
            self.assertIn(section, properties)


def _on_a_crack(mesh, vertex):
    return abs(mesh.attributes["crack_distance"].data[vertex].value) < 1e-9
