"""Arrays of any kind go in; what goes in comes out."""

import copy
import os
import pathlib
import pickle
import tempfile
import unittest

import numpy as np

import craze
from small import KEEP, Case, arrays, plate


def crack(mesh, **settings):
    return craze.crack(mesh, "mud", seed=7, max_cracks=5, **{**KEEP, **settings})


class Arrays(Case):
    def setUp(self):
        self.plate = plate()
        self.v, self.f = np.array(self.plate.vertices), np.array(self.plate.faces)
        self.wanted = crack((self.v, self.f)).mesh

    def test_any_dtype_and_stride_gives_the_same_bytes(self):
        v, f = self.v, self.f
        wide = np.zeros((len(v), 7))
        wide[:, 1:6:2] = v
        for name, vertices, faces in (
            ("big-endian", v.astype(">f8"), f.astype(">i8")),
            ("columns first", np.asfortranarray(v), np.asfortranarray(f)),
            ("every other column", wide[:, 1:6:2], f),
            ("turned round twice", v[::-1].copy()[::-1], f[::-1].copy()[::-1]),
            ("unsigned", v, f.astype(np.uint64)),
            ("floats that are whole", v, f.astype(np.float32)),
            ("long doubles", v.astype(np.longdouble), f),
            ("lists", v.tolist(), f.tolist()),
        ):
            with self.subTest(name):
                self.assert_same(crack((vertices, faces)).mesh, self.wanted)

    def test_read_only_arrays_go_in(self):
        self.v.flags.writeable = self.f.flags.writeable = False
        self.assert_same(crack((self.v, self.f)).mesh, self.wanted)

    def test_arrays_that_fit_are_not_copied(self):
        mesh = craze.Mesh(self.v, self.f)
        self.assertTrue(np.shares_memory(mesh.vertices, self.v))
        self.assertTrue(np.shares_memory(mesh.faces, self.f))

    def test_what_is_written_to_an_array_counts_in_the_next_run(self):
        mesh = craze.Mesh(self.v, self.f)
        crack(mesh)
        self.v *= 2
        self.assert_same(crack(mesh).mesh, crack((self.v.copy(), self.f)).mesh)
        self.f[0, 0] = len(self.v)
        self.assert_error("wrong faces", "usage", crack, mesh)

    def test_what_is_no_mesh_is_refused_in_one_line(self):
        v, f, masked = self.v, self.f, np.ma.masked_greater(self.v, 0.1)
        for words, vertices, faces in (
            ("wrong vertices .*shape", v[:, :2], f),
            ("wrong vertices .*shape", v.reshape(-1), f),
            ("wrong vertices .*complex", v.astype(complex), f),
            ("wrong vertices", "text", f),
            ("wrong vertices", v.astype(object), f),
            ("wrong vertices", [[1, 2, 3], [4]], f),
            ("masked", masked, f),
            ("wrong faces .*indices", v, f - 1),
            ("wrong faces .*indices", v, f.astype(np.uint64) + 2**63),
            ("wrong faces .*indices", v, f.astype(np.int64) + 2**32),
            ("not whole", v, np.where(f == 3, np.nan, f)),
            ("not whole", v, f + 0.5),
            ("wrong faces", v, np.full(f.shape, np.inf)),
            ("bool", v, f > 3),
            ("wrong faces .*shape", v, np.empty((0, 4), int)),
        ):
            with self.subTest(words):
                self.assert_error(words, "usage", craze.Mesh, vertices, faces)
        for mesh in (None, "plate", (v,), 3):
            self.assert_error("wrong mesh", "usage", craze.crack, mesh)

    def test_meshes_without_area_and_places_without_number_are_refused(self):
        self.assert_error("nothing to crack", "input", crack, ([], []))
        self.assert_error("nothing to crack", "input", crack, (self.v, np.empty((0, 3), int)))
        self.assert_error("vertex 5", "input", crack,
                          (np.where(np.arange(len(self.v))[:, None] == 5, np.nan, self.v), self.f))

    def test_order_and_attributes_are_kept(self):
        n, m = len(self.v), len(self.f)
        mesh = craze.Mesh(
            self.v, self.f, uv=self.v[:, :2],
            vertex_attributes={"number": np.arange(n), "color": np.full((n, 3), 0.5),
                               "flow": self.v[::-1]},
            face_attributes={"sort": np.arange(m) % 3})
        out = craze.crack(mesh, "mud", max_cracks=0, **KEEP).mesh
        self.assertTrue(np.array_equal(out.vertices, self.v))
        self.assertTrue(np.array_equal(out.faces, self.f))
        self.assertTrue(np.array_equal(out.uv, self.v[:, :2][self.f]))
        self.assertTrue(np.array_equal(out.vertex_attributes["number"], np.arange(n)))
        self.assertTrue(np.array_equal(out.vertex_attributes["flow"], self.v[::-1]))
        self.assertTrue(np.allclose(out.vertex_attributes["color"], [0.5, 0.5, 0.5, 1]))
        self.assertTrue(np.array_equal(out.face_attributes["sort"], np.arange(m) % 3))
        self.assertTrue(np.array_equal(out.face_attributes["source_face"], np.arange(m)))
        cut = crack(mesh).mesh
        source = cut.face_attributes["source_face"].astype(int)
        self.assertTrue(np.array_equal(cut.face_attributes["sort"], source % 3))

    def test_attributes_that_do_not_fit_are_refused(self):
        n = len(self.v)
        for words, name, values in (
            ("shape", "a", np.zeros(n + 1)), ("shape", "a", np.zeros((n, 2, 2))),
            ("shape", "a", np.zeros((n, 0))), ("numbers", "a", ["x"] * n),
            ("zero bytes", "a\0b", np.zeros(n)), ("wrong attribute", "\udcff", np.zeros(n)),
            ("vertex:", "", np.zeros(n)), ("columns", "color", np.zeros((n, 2))),
        ):
            with self.subTest(words):
                self.assert_error(words, "usage", crack,
                                  craze.Mesh(self.v, self.f, vertex_attributes={name: values}))
        self.assert_error("wrong uv", "usage", craze.Mesh, self.v, self.f, uv=np.zeros((3, 3)))

    def test_pictures_of_any_depth_count_alike(self):
        grey = (np.add.outer(np.arange(8), np.arange(8)) % 5 * 60 + 10).astype(np.uint8)
        rgb = np.repeat(grey[:, :, None], 3, axis=2)
        runs = []
        for picture in (grey, grey.astype(np.uint16) * 257, grey.astype(">u2") * 257, rgb,
                        np.dstack([rgb, 255 - grey]), grey[::-1].copy()[::-1]):
            mesh = craze.Mesh(self.v, self.f, uv=self.v[:, :2], textures={"spots": picture})
            runs.append(crack(mesh, **{"stress.texture": "spots"}).mesh)
        for run in runs[1:]:
            self.assertTrue(np.allclose(run.vertices[: len(self.v)], runs[0].vertices[: len(self.v)]))
        self.assert_same(runs[1], runs[0])
        self.assert_same(runs[5], runs[0])
        plain = crack(craze.Mesh(self.v, self.f, uv=self.v[:, :2])).mesh
        self.assertFalse(np.array_equal(plain.vertices, runs[0].vertices))

    def test_pictures_that_are_none_are_refused(self):
        for picture in (np.zeros(3), np.zeros((2, 2, 5)), np.zeros((0, 3)), np.full((2, 2), 255.0),
                        np.zeros((2, 2), int), [["a"]]):
            mesh = craze.Mesh(self.v, self.f, uv=self.v[:, :2], textures={"t": picture})
            self.assert_error(r"t[ )]|texture t", "usage", crack, mesh)


class Files(Case):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.mesh = crack(plate()).mesh

    def test_a_file_reads_back_as_it_was_under_any_name(self):
        root = self.folder.name
        for path in (f"{root}/plain.ply", pathlib.Path(root, "Höhe € 漆.ply"),
                     os.fsencode(root) + b"/latin\xff.ply"):
            self.mesh.write(path)
            self.assert_same(craze.read(path), self.mesh)
        names = {os.fsdecode(name) for name in os.listdir(os.fsencode(root))}
        self.assertEqual(len(names), 3)

    def test_materials_and_normals_survive_a_change_of_another_array(self):
        path = pathlib.Path(self.folder.name, "two.obj")
        path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\n"
                        "usemtl clay\nf 1//1 2//1 3//1\nusemtl glass\nf 1//1 3//1 4//1\n")
        mesh = craze.read(path)
        self.assertEqual(mesh.material_names, ["clay", "glass"])
        mesh.vertex_attributes["heat"] = np.arange(4.0)
        mesh.write(path.with_suffix(".ply"))
        mesh.write(path)
        again = craze.read(path)
        self.assertEqual(again.material_names, ["clay", "glass"])
        self.assertTrue(np.array_equal(again.face_attributes["material"], [0, 1]))
        self.assertTrue(np.array_equal(again.normals, np.full((2, 3, 3), [0, 0, 1.0])))
        mesh.face_attributes["material"] = [0, 2]
        self.assert_error("attribute material", "usage", mesh.write, path)

    def test_what_cannot_be_read_or_written_is_one_line(self):
        self.assert_error("nowhere", "input", craze.read, "nowhere.ply")
        self.assert_error("nowhere", "output", self.mesh.write, "nowhere/a.ply")
        self.assert_error("doc", "usage", self.mesh.write, f"{self.folder.name}/a.doc")
        for path in ("a\0.ply", None, 3.5):
            self.assert_error("wrong path", "usage", self.mesh.write, path)
            self.assert_error("wrong path", "usage", craze.read, path)
        for name in ("plait", "plate?n=x", "plate\0", None):
            self.assert_error("shape|plait|plate", "usage", craze.shape, name)
        self.assertEqual(os.listdir(self.folder.name), [])


class Copies(Case):
    def test_copies_and_pickles_hold_the_same_and_stand_alone(self):
        mesh = crack(plate()).mesh
        for other in (copy.copy(mesh), copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh))):
            self.assert_same(other, mesh)
            self.assert_same(crack(other).mesh, crack(mesh).mesh)
        other = copy.deepcopy(mesh)
        before = arrays(mesh)
        other.vertices += 1
        other.vertex_attributes.clear()
        del other
        self.assertEqual(mesh.vertices.tobytes(), before["vertices"].tobytes())
        self.assertIn("crack_time", mesh.vertex_attributes)

    def test_an_array_that_took_anothers_place_is_used(self):
        mesh = plate()
        for scale in range(2, 6):  # the freed array's address comes back soon
            mesh.vertices = np.array(mesh.vertices) * scale
            self.assert_same(crack(mesh).mesh, crack(copy.deepcopy(mesh)).mesh)

    def test_lines_pickle_and_runs_do_not(self):
        result = crack(plate())
        lines = pickle.loads(pickle.dumps(result.lines))
        self.assertTrue(np.array_equal(lines.points, result.lines.points))
        for clone in (copy.copy, copy.deepcopy, pickle.dumps):
            try:
                other = clone(result)
            except TypeError as e:
                self.assertIn("process", str(e))
            else:
                self.assertIs(other._job, result._job)  # a shallow copy shares the run
        with self.assertRaises(TypeError):
            copy.deepcopy(result)
        error = pickle.loads(pickle.dumps(craze.Error("wrong", "input")))
        self.assertEqual((str(error), error.kind), ("wrong", "input"))

    def test_everything_says_what_it_is_in_one_short_line(self):
        result = crack(plate())
        for thing in (result, result.mesh, result.lines, plate()):
            self.assertRegex(repr(thing), r"^<craze\.\w+[ :].*\d.*>$")
            self.assertLess(len(repr(thing)), 80)


if __name__ == "__main__":
    unittest.main()
