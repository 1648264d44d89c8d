"""A run from Python: the contract of the package."""

import json
import pathlib
import subprocess
import tempfile
import time
import unittest

import numpy as np

import craze
from craze._library import call
from small import COMMAND, KEEP, SOURCE, Case, cracked, plate


class Recipes(Case):
    def test_presets_and_parameters_are_those_of_the_recipes(self):
        presets = craze.presets()
        files = {path.stem for path in (SOURCE / "recipes").glob("*.toml")}
        self.assertEqual(set(presets), files)
        keys = {p["key"] for p in craze.parameters()}
        self.assertIn("layer.spacing", keys)
        for name in presets["mud"]["layer"]:
            self.assertIn(f"layer.{name}", keys)
        for parameter in craze.parameters():
            self.assertGreaterEqual(set(parameter), {"key", "type", "default", "unit", "help"})

    def test_a_preset_its_dict_and_a_file_of_it_are_the_same(self):
        wanted = craze.crack(plate(), "mud", max_cracks=5, **KEEP).mesh
        recipe = craze.presets()["mud"]
        self.assert_same(craze.crack(plate(), recipe, max_cracks=5, **KEEP).mesh, wanted)
        file = SOURCE / "recipes/mud.toml"
        for path in (file, str(file)):
            self.assert_same(craze.crack(plate(), path, max_cracks=5, **KEEP).mesh, wanted)

    def test_numbers_of_any_kind_are_keys_values(self):
        a = cracked(**{"material.alpha": np.float32(0.5), "material.toughness": np.int16(3)})
        recipe = {"material": {"alpha": np.float64(0.5)}, "mesh": {"edge": "keep"}}
        self.assertEqual(a.report["recipe"]["material"]["alpha"], 0.5)
        b = craze.crack(plate(), recipe, seed=np.uint8(3), max_cracks=1)
        self.assertEqual(b.report["seed"], 3)

    def test_wrong_keys_and_values_say_which_and_why(self):
        loop = {}
        loop["layer"] = loop
        deep = []
        for _ in range(100000):
            deep = [deep]
        for words, recipe, settings in (
            ("did you mean layer.spacing", "mud", {"layer.spacin": 1}),
            ("layer.spacing = -1 .*at least", "mud", {"layer.spacing": -1}),
            ("layer.spacing .*finite", "mud", {"layer.spacing": float("nan")}),
            ("layer.spacing", "mud", {"layer.spacing": None}),
            ("layer.spacing", "mud", {"layer.spacing": [deep]}),
            ("layer.spacing", "mud", {"layer.spacing": object()}),
            ("wrong key", "mud", {"seed\0": 1}),
            ("did you mean mud", "mudd", {}),
            ("zero bytes", "mud\0", {}),
            ("wrong preset", "\udcff", {}),
            ("wrong recipe", 3, {}),
            ("unknown key", {"layer": {"thick": 1}}, {}),
            ("the recipe", loop, {}),
            ("wrong type", {"layer": 1}, {}),
        ):
            with self.subTest(words):
                self.assert_error(words, "usage", craze.crack, plate(), recipe, **settings)
        self.assert_error("nowhere.toml", "input", craze.crack, plate(), "nowhere.toml")
        self.assert_error("mud", "input", craze.crack, plate(), pathlib.Path("mud"))

    def test_wrong_numbers_are_refused_and_not_rounded(self):
        for name, values in (
            ("seed", (-1, 2**70, 1.5, "7")), ("threads", (-1, 2**40, 1.0)),
            ("max_cracks", (-1, 2**70, 2.5)), ("progress", (3, "print")),
        ):
            for value in values:
                with self.subTest(name, value=value):
                    self.assert_error(name, "usage", craze.crack, plate(), "mud", **{name: value})


class Products(Case):
    @classmethod
    def setUpClass(cls):
        cls.result = cracked(**{"post.gap": 0.1, "post.wall": 0.02})

    def test_the_same_seed_gives_the_same_bytes_on_any_number_of_threads(self):
        other = craze.crack(plate(), "mud", 7, threads=3, max_cracks=12,
                            **{**KEEP, "post.gap": 0.1, "post.wall": 0.02})
        self.assert_same(other.mesh, self.result.mesh)
        self.assertFalse(np.array_equal(
            craze.crack(plate(), "mud", 8, max_cracks=12, **KEEP).mesh.vertices,
            cracked().mesh.vertices))

    def test_shapes_and_types_are_as_the_docstrings_say(self):
        mesh, lines = self.result.mesh, self.result.lines
        n, m, p, e = len(mesh.vertices), len(mesh.faces), len(lines.points), len(lines.edges)
        for array, shape, dtype in (
            (mesh.vertices, (n, 3), "f8"), (mesh.faces, (m, 3), "i4"), (mesh.uv, (m, 3, 2), "f8"),
            (mesh.vertex_attributes["crack_distance"], (n,), "f8"),
            (mesh.vertex_attributes["crack_time"], (n,), "f8"),
            (mesh.vertex_attributes["crack_growth"], (n,), "f8"),
            (mesh.vertex_attributes["displacement"], (n, 3), "f8"),
            (mesh.face_attributes["fragment"], (m,), "f8"),
            (mesh.face_attributes["source_face"], (m,), "f8"),
            (lines.points, (p, 3), "f8"), (lines.edges, (e, 2), "i4"), (lines.time, (e,), "f8"),
            (lines.width, (e,), "f8"), (lines.event, (e,), "f8"), (lines.junction, (p,), "f8"),
            (lines.normal, (p, 3), "f8"), (lines.uv, (e, 2, 2), "f8"),
        ):
            self.assertEqual(array.shape, shape)
            self.assertEqual(array.dtype, np.dtype(dtype))
            self.assertFalse(array.flags.writeable)
            with self.assertRaises(ValueError):
                array.flags.writeable = True
        self.assertGreater(e, 0)
        self.assertLess(lines.edges.max(), p)

    def test_opening_twice_cracks_once_and_growth_ends_at_the_opened_mesh(self):
        opened = self.result.opened()
        self.assertTrue(np.array_equal(self.result.positions_at(1), opened.vertices))
        self.assertGreater(len(opened.vertices), len(self.result.mesh.vertices))
        wide = self.result.opened(gap=0.2)
        self.assertFalse(np.array_equal(wide.vertices, opened.vertices))
        self.assertTrue(np.array_equal(self.result.opened().vertices, opened.vertices))
        start = self.result.positions_at(0)
        self.assertEqual(start.shape, opened.vertices.shape)
        self.assertFalse(np.array_equal(start, opened.vertices))
        self.assertIsInstance(self.result.warnings(), list)
        for t in (-0.1, 1.5, float("nan")):
            self.assert_error("time", "usage", self.result.positions_at, t)
        self.assert_error("wrong time", "usage", self.result.positions_at, "soon")
        self.assert_error("gap", "request", self.result.opened, gap=float("nan"))
        self.assert_error("wrong gap", "usage", self.result.opened, gap="wide")

    def test_lengths_of_an_opening_may_have_units(self):
        low, high = self.result.mesh.vertices.min(axis=0), self.result.mesh.vertices.max(axis=0)
        wall = 0.02 * np.linalg.norm(high - low)
        by_share = self.result.opened(gap=0.1, wall="2%")
        self.assertTrue(np.allclose(by_share.vertices,
                                    self.result.opened(gap=0.1, wall=wall).vertices, atol=1e-12))
        self.assertEqual(len(self.result.fragments(thickness="1%")),
                         len(self.result.fragments()))
        self.assert_error("wall", "usage", self.result.opened, wall="2 parsecs")

    def test_roughness_changes_without_cracking_again_to_the_bytes_of_a_run_that_had_it(self):
        rough = {"post.roughness": 0.01, "post.gap": 0.1, "post.wall": 0.02}
        fresh = cracked(**rough)
        self.assert_same(self.result.opened(roughness=0.01), fresh.opened())
        self.assert_same(fresh.opened(roughness=0), self.result.opened())
        self.assert_same(self.result.opened(roughness=0.01, gap=0.2), fresh.opened(gap=0.2))
        self.assertGreater(len(fresh.mesh.faces), len(self.result.mesh.faces))
        pieces = len(np.unique(self.result.mesh.face_attributes["fragment"]))
        self.assertEqual(len(self.result.opened(relative_roughness=0.05).fragments()), pieces)
        held_back = self.result.warnings(roughness=1000)
        self.assertTrue(any("post.roughness" in warning for warning in held_back))
        self.assert_error("roughnes", "usage", self.result.opened, roughnes=0.01)
        self.assert_error("roughness", "usage", self.result.opened, roughness=-1)

    def test_a_result_with_another_post_is_that_of_a_run_that_had_it(self):
        """Lines, maps, recipe and file; the result itself stays as it is."""
        post = {"gap_width": 0.02, "curl": 0.5, "roughness": 0.01}
        first = cracked()
        before = first.recipe
        changed = first.with_post(**post)
        run = cracked(**{f"post.{key}": value for key, value in post.items()})
        self.assertEqual(changed.recipe, run.recipe)
        self.assertGreater(changed.recipe["post"]["gap"], 0)
        np.testing.assert_array_equal(changed.lines.points, run.lines.points)
        height, wanted = (r.bake(24, ["height"])["height"] for r in (changed, run))
        np.testing.assert_array_equal(height, wanted)
        self.assert_same(changed.opened(), run.opened())
        self.assertEqual(first.recipe, before)
        self.assertLess(len(first.lines.points), len(changed.lines.points))

    def test_the_recipe_of_a_run_makes_the_run_again(self):
        first = cracked(**{"layer.spacing": "20%", "post.gap": 0.1})
        again = craze.crack(plate(), first.recipe, max_cracks=12)
        self.assertEqual(again.recipe, first.recipe)
        self.assert_same(again.opened(), first.opened())

    def test_solid_fragments_have_the_mass_that_numpy_finds(self):
        solids = self.result.fragments(thickness=0.1)
        self.assertEqual(len(solids), len(self.result.fragments()))
        for solid in solids:
            corners = solid.vertices[solid.faces]
            edges = np.concatenate([solid.faces[:, [i, (i + 1) % 3]] for i in range(3)])
            self.assertEqual({tuple(e) for e in edges}, {tuple(e[::-1]) for e in edges})
            self.assertEqual(len({tuple(e) for e in edges}), len(edges))
            # Points of a rule that is exact for squares: corners and middle of tetrahedra.
            w = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
            middle = corners.sum(axis=1) / 4
            centre = (w[:, None] * middle).sum(axis=0) / w.sum()
            moments = np.zeros((3, 3))
            for points, share in ((corners, 1 / 20), (middle[:, None], 16 / 20)):
                away = points - centre
                moments += share * np.einsum("i,ijk,ijl->kl", w, away, away)
            moments += w.sum() / 20 * np.outer(centre, centre)  # the corner at the origin
            found = solid.mass_properties()
            self.assertGreater(found["volume"], 0)
            self.assertAlmostEqual(found["volume"], w.sum(), 12)
            np.testing.assert_allclose(found["centre"], centre, atol=1e-9)
            inertia = np.trace(moments) * np.eye(3) - moments
            np.testing.assert_allclose(found["inertia"], inertia, atol=1e-9)
            hull = solid.convex_hull()
            self.assertGreaterEqual(hull.mass_properties()["volume"], 0.9 * found["volume"])

    def test_a_thickness_of_nonsense_is_an_error(self):
        for bad in (-1.0, float("nan"), float("inf")):
            with self.assertRaises(craze.Error):
                self.result.opened(thickness=bad)

    def test_fragments_are_the_mesh_in_pieces(self):
        pieces = self.result.fragments()
        fragment = self.result.mesh.face_attributes["fragment"]
        self.assertEqual([len(p.faces) for p in pieces],
                         [np.count_nonzero(fragment == i) for i in np.unique(fragment)])
        self.assert_error("fragment", "request", plate().fragments)

    def test_statistics_are_part_of_the_report(self):
        # A number that is not there is null in one and NaN in the other nowhere.
        self.assertEqual(self.result.stats(), self.result.report["statistics"])
        lines = self.result.lines
        of_lines = craze.stats(lines.points[:, :2], lines.edges, lines.time)
        self.assertEqual(of_lines["crack_length"], self.result.stats()["crack_length"])
        self.assertEqual(craze.crack(plate(), "mud", max_cracks=0, **KEEP).stats(), {})

    def test_lines_that_are_none_are_refused(self):
        points, edges = [[0, 0], [1, 0], [0, 1]], [[0, 1], [1, 2]]
        for words, *given in (
            ("points", [[0]], edges), ("points", "text", edges), ("edges", points, [[0, 3]]),
            ("edges", points, [[0, -1]]), ("edges", points, [[0, 2**40]]),
            ("edges", points, [[0.5, 1]]), ("edges", points, [[np.nan, 1]]),
            ("time", points, edges, [1]), ("time", points, edges, [0, np.nan]),
            ("simplify", points, edges, None, -1), ("simplify", points, edges, None, "much"),
            ("point", [[0, 0], [1, np.inf], [0, 1]], edges),
        ):
            with self.subTest(words):
                self.assert_error(words, "usage", craze.stats, *given)


class Command(Case):
    @unittest.skipUnless(COMMAND, "the command is not built")
    def test_the_files_and_the_report_are_those_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.ply", "a.obj", "a.stl", "a.glb"):
                # Curled surfaces have no normals but those that the command gives a GLB.
                curl = 0 if name == "a.glb" else 0.3
                settings = {"mesh.edge": "keep", "post.gap": 0.08, "post.wall": 0.02,
                            "post.curl": curl}
                theirs, ours = f"{folder}/theirs_{name}", f"{folder}/ours_{name}"
                sets = [word for key, value in settings.items()
                        for word in ("--set", f"{key}={value}")]
                subprocess.run(
                    [COMMAND, "crack", "shape:bowl?n=8", "--preset", "mud", "--seed",
                     "7", "-o", theirs, "--report", f"{folder}/report.json", *sets], check=True,
                    stderr=subprocess.DEVNULL)
                result = craze.crack(craze.shape("bowl?n=8"), "mud", 7, **settings)
                result.write(ours)
                self.assertEqual(pathlib.Path(ours).read_bytes(),
                                 pathlib.Path(theirs).read_bytes(), name)
            report = json.loads(pathlib.Path(folder, "report.json").read_text())
        self.assertEqual(set(result.report), set(report))
        for key in ("seed", "recipe", "cracks", "simulation", "statistics", "stop_reason", "load"):
            self.assertEqual(result.report[key], report[key], key)


class Overhead(Case):
    """By processor time: that of a clock has other programs in it."""

    def least(self, call):
        times = []
        for _ in range(5):
            start = time.process_time()
            call()
            times.append(time.process_time() - start)
        return min(times)

    def test_a_run_of_20000_triangles_costs_20_ms_more_than_in_c(self):
        shape = plate(100)
        mesh = craze.Mesh(np.array(shape.vertices), np.array(shape.faces))
        self.assertEqual(len(mesh.faces), 20000)
        result = craze.crack(mesh, "mud", threads=1, max_cracks=2, **KEEP)
        in_c = self.least(lambda: call("craze_job_run", result._job.pointer))
        in_python = self.least(lambda: craze.crack(mesh, "mud", threads=1, max_cracks=2, **KEEP))
        print(f"{1000 * (in_python - in_c):.1f} ms over {1000 * in_c:.0f} ms")
        self.assertLess(in_python - in_c, 0.02)


if __name__ == "__main__":
    unittest.main()
