"""Meshes that crack in no time, and what the tests are told by ctest."""

import os
import unittest
from pathlib import Path

import numpy as np

import craze

SOURCE = Path(os.environ.get("CRAZE_SOURCE_DIR", Path(__file__).parents[2]))
COMMAND = os.environ.get("CRAZE_COMMAND", "")
KEEP = {"mesh.edge": "keep", "post.relative_roughness": 0}


def plate(n=8):
    return craze.shape(f"plate?n={n}&jitter=0.3")


def cracked(n=8, **settings):
    return craze.crack(plate(n), "mud", seed=7, max_cracks=12, **{**KEEP, **settings})


def arrays(mesh):
    """All that a mesh holds, copied."""
    held = {"vertices": mesh.vertices, "faces": mesh.faces}
    if mesh.uv is not None:
        held["uv"] = mesh.uv
    held.update({f"vertex {k}": v for k, v in mesh.vertex_attributes.items()})
    held.update({f"face {k}": v for k, v in mesh.face_attributes.items()})
    return {k: np.array(v) for k, v in held.items()}


class Case(unittest.TestCase):
    def assert_same(self, a, b):
        """Two meshes hold the same bytes."""
        a, b = arrays(a), arrays(b)
        self.assertEqual(list(a), list(b))
        for name in a:
            self.assertEqual(a[name].tobytes(), b[name].tobytes(), name)

    def assert_error(self, words, kind, call, *arguments, **settings):
        """One line that says what is wrong, of that kind."""
        with self.assertRaises(craze.Error) as raised:
            call(*arguments, **settings)
        message = str(raised.exception)
        self.assertRegex(message, words)
        self.assertNotIn("\n", message)
        self.assertNotIn("--set", message)
        self.assertEqual(raised.exception.kind, kind, message)
