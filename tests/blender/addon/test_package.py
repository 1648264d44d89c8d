"""The zip, outside Blender: test_package.py ZIP PACKAGE. What it must hold to be installed as a legacy
add-on (3.4) and as an extension (4.2 and later), by the published rules of the manifest
(developer.blender.org/docs/features/extensions/schema)."""

import ast
import hashlib
import json
import re
import sys
import tomllib
import unittest
import zipfile
from pathlib import Path

ZIP, PACKAGE = (Path(p) for p in sys.argv[1:3])
FOLDER = "craze_blender/"
PLATFORMS = {"windows-x64", "windows-arm64", "macos-x64", "macos-arm64", "linux-x64", "linux-arm64"}
PERMISSIONS = {"files", "network", "clipboard", "camera", "microphone"}
VERSION = r"(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)"
FORBIDDEN_MODULES = {"socket", "urllib", "http", "ftplib", "smtplib", "requests", "ssl", "asyncio"}
FORBIDDEN_NAMES = {"eval", "exec", "compile", "__import__"}


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with zipfile.ZipFile(ZIP) as archive:
            cls.files = {n: archive.read(n) for n in archive.namelist()}
            cls.entries = archive.infolist()
        cls.manifest = tomllib.loads(cls.files[FOLDER + "blender_manifest.toml"].decode())
        cls.python = {n: t.decode() for n, t in cls.files.items() if n.endswith(".py")}

    def test_the_manifest_has_what_is_required(self):
        m = self.manifest
        self.assertEqual(m["schema_version"], "1.0.0")
        self.assertTrue(m["id"].isidentifier() and "__" not in m["id"].strip("_"))
        self.assertEqual(m["id"] + "/", FOLDER)
        self.assertRegex(m["version"], f"^{VERSION}$")
        self.assertTrue(m["name"] and m["name"] == m["name"].strip())
        self.assertEqual(m["type"], "add-on")
        self.assertRegex(m["maintainer"], r"^[^<>]+ <[^<>@ ]+@[^<>@ ]+>$")
        self.assertRegex(m["blender_version_min"], f"^{VERSION}$")
        self.assertGreaterEqual(tuple(map(int, m["blender_version_min"].split("."))), (4, 2, 0))
        self.assertEqual(m["license"], ["SPDX:MIT"])
        for line in m["copyright"]:
            self.assertRegex(line, r"^\d{4}(-\d{4})? \S.*$")

    def test_what_users_read_is_short_and_without_full_stop(self):
        self.assertLessEqual(set(self.manifest["permissions"]), PERMISSIONS)
        for text in (self.manifest["tagline"], *self.manifest["permissions"].values()):
            self.assertTrue(0 < len(text) <= 64 and text[-1].isalnum(), text)

    def test_it_asks_for_no_network(self):
        self.assertEqual(set(self.manifest["permissions"]), {"files"})

    def test_the_index_beside_it_is_of_this_zip(self):
        index = json.loads(ZIP.with_name("index.json").read_text("utf-8"))
        self.assertEqual((index["version"], index["blocklist"]), ("v1", []))
        [entry] = index["data"]
        content = ZIP.read_bytes()
        self.assertEqual(entry.pop("archive_size"), len(content))
        self.assertEqual(entry.pop("archive_hash"), "sha256:" + hashlib.sha256(content).hexdigest())
        self.assertEqual(entry.pop("archive_url"), f"./{ZIP.name}")
        self.assertEqual(entry, self.manifest)

    def test_platforms_are_those_of_the_engine(self):
        self.assertLessEqual(set(self.manifest["platforms"]), PLATFORMS)
        engine = self.files[FOLDER + "engine/craze/libcraze.so"]
        self.assertEqual(engine[:5], b"\x7fELF\x02")  # 64 bits
        machine = {0x3E: "linux-x64", 0xB7: "linux-arm64"}[engine[18]]
        self.assertEqual(self.manifest["platforms"], [machine])
        self.assertTrue(ZIP.stem.endswith(machine))

    def test_both_kinds_of_add_on_say_the_same_version(self):
        tree = ast.parse(self.python[FOLDER + "__init__.py"])
        info = next(ast.literal_eval(n.value) for n in tree.body if isinstance(n, ast.Assign)
                    and n.targets[0].id == "bl_info")  # fmt: skip
        self.assertEqual(".".join(map(str, info["version"])), self.manifest["version"])
        self.assertEqual(info["blender"], (3, 4, 0))
        table = json.loads(self.files[FOLDER + "table.json"])
        self.assertEqual(table["version"], self.manifest["version"])

    def test_all_is_in_one_folder_with_safe_names(self):
        for entry in self.entries:
            self.assertTrue(entry.filename.startswith(FOLDER), entry.filename)
            self.assertRegex(entry.filename, r"^[A-Za-z0-9_./-]+$")
            self.assertNotIn("..", entry.filename)
            self.assertNotIn("__pycache__", entry.filename)
        for name in ("__init__.py", "blender_manifest.toml", "LICENSE", "worker/__main__.py"):
            self.assertIn(FOLDER + name, self.files)

    def test_the_engine_is_the_package(self):
        for path in PACKAGE.iterdir():
            if path.suffix in {".py", ".so"}:
                self.assertEqual(self.files[f"{FOLDER}engine/craze/{path.name}"], path.read_bytes())

    def test_the_python_is_3_10_to_3_13_and_says_no_eval_and_no_network(self):
        self.assertGreater(len(self.python), 20)
        for name, text in self.python.items():
            for minor in (10, 11, 13):
                tree = ast.parse(text, name, feature_version=(3, minor))
            compile(tree, name, "exec")
            for node in ast.walk(tree):
                modules = []
                if isinstance(node, ast.Import):
                    modules = [a.name for a in node.names]
                elif isinstance(node, ast.ImportFrom):
                    modules = [node.module or ""]
                for module in modules:
                    self.assertNotIn(module.split(".")[0], FORBIDDEN_MODULES, name)
                if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                    self.assertNotIn(node.func.id, FORBIDDEN_NAMES, name)

    def test_each_preset_has_a_small_picture(self):
        presets = json.loads(self.files[FOLDER + "table.json"])["presets"]
        pictures = {n: t for n, t in self.files.items() if n.startswith(FOLDER + "pictures/")}
        self.assertEqual(set(pictures), {f"{FOLDER}pictures/{name}.png" for name in presets})
        for name, content in pictures.items():
            self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n", name)
            self.assertLess(len(content), 32768, name)

    def test_operators_and_panels_are_named_as_blender_wants(self):
        for name, text in self.python.items():
            for kind, cls in re.findall(r"^class \w+_(OT|PT)_(\w+)\(", text, re.M):
                self.assertIn(f"CRAZE_{kind}_{cls}", text, name)
            for idname in re.findall(r'bl_idname = "(.*)"', text):
                self.assertRegex(idname, r"^craze\.[a-z_]+$")


unittest.main(argv=sys.argv[:1], verbosity=2)
