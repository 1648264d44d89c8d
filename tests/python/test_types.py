"""The package and its examples are typed throughout; skipped without mypy."""

import os
import shutil
import subprocess
import tempfile
import unittest

from small import SOURCE


@unittest.skipUnless(shutil.which("mypy"), "no mypy (apt: mypy)")
class Types(unittest.TestCase):
    def check(self, *arguments):
        with tempfile.TemporaryDirectory() as cache:
            run = subprocess.run(["mypy", "--strict", "--cache-dir", cache, *arguments],
                                 cwd=SOURCE / "bindings/python", text=True, capture_output=True,
                                 env={**os.environ, "PYTHONPATH": "", "MYPYPATH": "."})
        return run.returncode, run.stdout + run.stderr

    def test_the_package_and_the_examples_are_what_they_are_said_to_be(self):
        examples = [str(path) for path in (SOURCE / "bindings/python/examples").glob("*.py")]
        code, said = self.check("craze", "make_wheel.py", *examples)
        self.assertEqual(code, 0, said)
        self.assertGreater(len(examples), 4)

    def test_a_wrong_call_is_found(self):
        code, said = self.check("-c", "import craze; craze.crack(craze.shape('cup'), seed='seven')")
        self.assertEqual(code, 1, said)
        self.assertIn("seed", said)


if __name__ == "__main__":
    unittest.main()
