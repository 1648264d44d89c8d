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
            command += "--size 64 --seeds 2 --steps 40 --batch 4 --channels 8 --parts 2".split()
            subprocess.run([*command, "--device", "cpu"], check=True, stdout=subprocess.DEVNULL)
            runs = json.loads(results.read_text())["runs"]
            self.assertEqual(len(runs), 2 * 6)
            self.assertGreater(min(run["measures"]["f1"] for run in runs), 0.5)
            told = subprocess.run([sys.executable, FOLDER / "table.py", results], check=True,
                                  capture_output=True, text=True).stdout
            for arm in ("craze", "voronoi", "walks", "real 2", "craze + real 2"):
                self.assertRegex(told, rf"\| {arm.replace('+', '.')} \| [0-9 +]+ \| 2 \|")
