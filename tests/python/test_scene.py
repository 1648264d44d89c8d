"""What a file held besides its surface goes along: the same files as the command's."""

import copy
import importlib.util
import json
import struct
import subprocess
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np

import craze
from small import COMMAND, SOURCE, Case

_spec = importlib.util.spec_from_file_location("truck", SOURCE / "tests/gltf/truck.py")
truck = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(truck)
SETTINGS = {"layer.relative_spacing": 0.2}
OPEN = {**SETTINGS, "post.gap": 0.1, "post.wall": 0.02, "post.curl": 0.5}


def document(path):
    data = Path(path).read_bytes()
    return json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])


def names(path, kind):
    return [item.get("name", "") for item in document(path).get(kind, [])]


class Scene(Case):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name)
        self.given = self.path / "truck.glb"
        truck.truck(self.given)

    def tearDown(self):
        self.folder.cleanup()

    def crack(self, mesh, **settings):
        return craze.crack(mesh, "glaze", 3, **{**SETTINGS, **settings})

    def command(self, name, settings):
        sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        subprocess.run([COMMAND, "crack", self.given, "--preset", "glaze", "--seed", "3", "-o",
                        self.path / name, "--quiet", "--no-warnings", *sets], check=True)
        return (self.path / name).read_bytes()

    def quietly(self, write, name):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            write(self.path / name)
        return [str(warning.message) for warning in told]

    @unittest.skipUnless(COMMAND, "the command is not built")
    def test_files_are_those_of_the_command(self):
        for settings in (SETTINGS, OPEN):
            result = craze.crack(craze.read(self.given), "glaze", 3, **settings)
            for name in ("a.glb", "a.obj", "a.ply", "a.usda"):
                theirs = self.command(name, settings)
                self.quietly(result.write, name)
                self.assertEqual((self.path / name).read_bytes(), theirs, name)
            self.assertEqual(self.command("a.obj", settings) and
                             (self.path / "a.mtl").read_text().count("newmtl"),
                             5 if settings is OPEN else 4)

    def test_the_cut_mesh_is_the_scene_with_its_cracks_shut(self):
        self.crack(craze.read(self.given)).mesh.write(self.path / "cut.glb")
        for kind in ("animations", "skins", "cameras", "images"):
            self.assertEqual(names(self.path / "cut.glb", kind), names(self.given, kind))
        self.assertIn("crack_lines", names(self.path / "cut.glb", "nodes"))

    def test_what_is_read_is_written_as_it_was(self):
        craze.read(self.given).write(self.path / "again.glb")
        self.assertEqual(document(self.path / "again.glb"), document(self.given))

    def test_new_attributes_and_places_go_with_the_scene(self):
        mesh = craze.read(self.given)
        mesh.vertex_attributes["paint"] = np.ones(len(mesh.vertices))
        result = self.crack(mesh, **{"where.attribute": "paint"})
        result.write(self.path / "painted.glb")
        self.assertEqual(names(self.path / "painted.glb", "animations"), ["sway", "wave"])
        cut = result.mesh
        cut.vertices = cut.vertices + [0, 1, 0]
        cut.write(self.path / "up.glb")
        self.assertEqual(names(self.path / "up.glb", "animations"), ["sway", "wave"])
        moved = craze.read(self.path / "up.glb")
        self.assertAlmostEqual(moved.vertices[:, 1].max(), cut.vertices[:, 1].max(), places=5)

    def test_new_attributes_reach_parts_that_nothing_has_cracked(self):
        mesh = craze.read(self.given)
        number = np.arange(len(mesh.vertices), dtype=float)
        mesh.vertex_attributes["number"] = number
        mesh.write(self.path / "numbered.glb")
        self.assertEqual(names(self.path / "numbered.glb", "animations"), ["sway", "wave"])
        kept = craze.read(self.path / "numbered.glb")
        self.assertTrue(np.array_equal(kept.vertex_attributes["number"], number))
        cracked = self.path / "cracked.glb"
        craze.crack(mesh, "glaze", 3, max_cracks=2, **SETTINGS).write(cracked)
        found = craze.read(cracked).vertex_attributes["number"]
        self.assertGreater(found.max(), 0.99 * number.max())  # the last part's; welded ones have one

    def test_new_attributes_of_many_columns_are_kept_one_by_one(self):
        mesh = craze.read(self.given)
        wide = np.arange(6.0 * len(mesh.vertices)).reshape(-1, 6)
        mesh.vertex_attributes["wide"] = wide
        mesh.write(self.path / "wide.glb")
        kept = craze.read(self.path / "wide.glb").vertex_attributes
        for i in range(6):
            self.assertTrue(np.array_equal(kept[f"wide_{i}"], wide[:, i]))
        cracked = self.path / "cracked.glb"
        craze.crack(mesh, "glaze", 3, max_cracks=2, **SETTINGS).write(cracked)
        self.assertIn("wide_5", craze.read(cracked).vertex_attributes)

    def test_another_surface_and_copies_are_meshes_alone(self):
        mesh = craze.read(self.given)
        mesh.uv = np.array(mesh.uv) * 2
        for alone in (mesh, copy.deepcopy(craze.read(self.given))):
            alone.write(self.path / "alone.glb")
            self.assertEqual(names(self.path / "alone.glb", "animations"), [])

    def test_what_a_format_cannot_hold_is_said(self):
        told = self.quietly(self.crack(craze.read(self.given)).write, "a.stl")
        self.assertEqual(len(told), 2)  # of the surface, of the scene
        self.assertRegex(told[0], r"\.stl has no place.*texture coordinates")
        self.assertRegex(told[1], r"\.stl has no place.*2 animations")


if __name__ == "__main__":
    unittest.main()
