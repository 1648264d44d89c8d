"""benchmarks/transfer, all of it on pictures that are made here; skipped without PyTorch or Pillow."""

import importlib.util
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

from small import SOURCE

for name, package in (("torch", "python3-torch"), ("PIL", "python3-pil")):
    if importlib.util.find_spec(name) is None:
        print(f"skipped: no {name} (apt: {package})")
        sys.exit(77)

FOLDER = SOURCE / "benchmarks" / "transfer"
sys.path.insert(0, str(FOLDER))
from data import write_pair  # noqa: E402

SETS = ("craze", "craze_painted", "voronoi", "walks", "real/train", "real/test")


def write_sets(folder):
    """Dark lines on noise, and a picture without one, in each set."""
    random = np.random.default_rng(1)
    for name in SETS:
        for k in range(4):
            picture = random.integers(130, 220, (64, 64, 3)).astype(np.uint8)
            mask = np.zeros((64, 64), bool)
            if k:
                top = random.integers(5, 55)
                mask[top : top + 4] = True
            picture[mask] = 20
            write_pair(folder / name, f"{k}", picture, mask)


class Training(unittest.TestCase):
    def test_every_arm_is_trained_judged_and_told(self):
        with tempfile.TemporaryDirectory() as held:
            folder = Path(held)
            write_sets(folder)
            results = folder / "results.json"
            command = [sys.executable, FOLDER / "run.py", "--data", folder, "--out", results]
            command += "--size 64 --batch 4 --channels 8 --parts 2 --device cpu".split()

            def run(*more):
                made = subprocess.run([*command, *more], capture_output=True, text=True)
                return made, json.loads(results.read_text())["runs"]

            first, before = run("--seeds", "1", "--steps", "40")
            self.assertEqual((first.returncode, len(before)), (0, 6), first.stderr)
            then, runs = run("--seeds", "2", "--steps", "40")
            self.assertEqual((then.returncode, len(runs)), (0, 2 * 6), then.stderr)
            self.assertEqual(runs[:6], before, "what an earlier run made is kept")
            other, kept = run("--seeds", "2", "--steps", "41")
            self.assertEqual((other.returncode, kept), (1, runs))
            self.assertIn("other settings", other.stderr)
            self.assertGreater(min(run["measures"]["f1"] for run in runs), 0.5)
            told = subprocess.run([sys.executable, FOLDER / "table.py", results], check=True,
                                  capture_output=True, text=True).stdout
            for arm in ("craze", "voronoi", "walks", "real 2", "craze + real 2"):
                self.assertRegex(told, rf"\| {arm.replace('+', '.')} \| [0-9 +]+ \| 2 \|")
