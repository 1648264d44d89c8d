"""The wheel: what is in it, and that it runs where nothing else is."""

import base64
import csv
import hashlib
import os
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import craze
from small import SOURCE

PROGRAM = """
import craze
mesh = craze.shape("plate?n=8&jitter=0.3")
print(craze.__file__, craze.crack(mesh, "mud", max_cracks=3, **{"mesh.edge": "keep"}))
"""


class Wheel(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.wheel = self.make(self.folder)

    def make(self, folder):
        package = Path(craze.__file__).parent
        made = subprocess.run(
            [sys.executable, SOURCE / "bindings/python/make_wheel.py", package, craze.__version__,
             folder],
            check=True, text=True, stdout=subprocess.PIPE)
        return Path(made.stdout.strip())

    def test_its_name_says_that_any_python_3_will_do(self):
        machine = os.uname().machine
        self.assertEqual(self.wheel.name,
                         f"craze-{craze.__version__}-py3-none-linux_{machine}.whl")

    def test_its_record_is_right(self):
        info = f"craze-{craze.__version__}.dist-info"
        with zipfile.ZipFile(self.wheel) as wheel:
            record = {row[0]: row[1:] for row in
                      csv.reader(wheel.read(f"{info}/RECORD").decode().splitlines())}
            self.assertEqual(set(record), set(wheel.namelist()))
            for name, (digest, size) in record.items():
                if name == f"{info}/RECORD":
                    continue
                content = wheel.read(name)
                wanted = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=")
                self.assertEqual((digest, int(size)), (f"sha256={wanted.decode()}", len(content)))
            self.assertIn("craze/py.typed", record)
            self.assertIn(f"Version: {craze.__version__}\n",
                          wheel.read(f"{info}/METADATA").decode())

    def test_the_same_package_gives_the_same_bytes(self):
        again = self.folder / "again"
        again.mkdir()
        self.assertEqual(self.make(again).read_bytes(), self.wheel.read_bytes())

    def test_what_is_in_it_cracks(self):
        installed = self.folder / "site"
        with zipfile.ZipFile(self.wheel) as wheel:
            wheel.extractall(installed)
        run = subprocess.run([sys.executable, "-c", PROGRAM], cwd=self.folder, text=True,
                             capture_output=True, env={"PYTHONPATH": str(installed)})
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn(str(installed), run.stdout)
        self.assertIn("3 cracks", run.stdout)


if __name__ == "__main__":
    unittest.main()
