"""The examples of the page run, and are on the page as they are."""

import os
import subprocess
import sys
import tempfile
import unittest

from small import SOURCE

EXAMPLES = SOURCE / "bindings/python/examples"
WRITES = {
    "mud_on_arrays": ["mud.ply"],
    "painted_stress": ["painted.ply"],
    "growth_to_frames": [f"frame_{i:04d}.ply" for i in range(8)],
    "sweep_over_seeds": [],
    "compare_a_skeleton": [],
}


class Examples(unittest.TestCase):
    def test_the_page_holds_every_example_as_it_is(self):
        page = (SOURCE / "docs/python.md").read_text(encoding="utf-8")
        files = sorted(path.stem for path in EXAMPLES.glob("*.py"))
        self.assertEqual(files, sorted(WRITES))
        for name in files:
            text = (EXAMPLES / f"{name}.py").read_text(encoding="utf-8")
            self.assertIn(f"```python\n{text}```", page, name)

    def test_every_example_runs_and_writes_its_files(self):
        for name, files in WRITES.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                run = subprocess.run([sys.executable, "-W", "error", EXAMPLES / f"{name}.py"],
                                     cwd=folder, capture_output=True, text=True)
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertEqual(sorted(os.listdir(folder)), sorted(files))
                if not files:
                    self.assertGreater(len(run.stdout.splitlines()), 1)


if __name__ == "__main__":
    unittest.main()
