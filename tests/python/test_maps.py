"""Maps from Python."""

import unittest

import numpy as np

import craze
from small import KEEP, Case, cracked, plate


class Maps(Case):
    def test_all_are_arrays_by_name(self):
        maps = cracked().bake(24)
        self.assertEqual(
            set(maps),
            set(
                "mask height normal occlusion curvature distance width direction time crack "
                "fragment position".split()
            ),
        )
        for name, values in maps.items():
            color = name in ("normal", "direction", "position")
            self.assertEqual(values.shape, (24, 24, 3) if color else (24, 24), name)
            self.assertEqual(values.dtype, np.float32)
            self.assertTrue(np.isfinite(values).all(), name)

    def test_distance_is_that_to_the_lines(self):
        result = cracked()
        size = 64
        distance = result.bake(size, ["distance"])["distance"]
        lines = result.lines
        place = result.bake(size, ["position"])["position"].astype(float).reshape(-1, 3)
        a, b = (lines.points[lines.edges[:, i]] for i in (0, 1))
        along = b - a
        share = np.einsum("pes,es->pe", place[:, None] - a, along) / np.sum(along**2, axis=1)
        feet = a + np.clip(share, 0, 1)[..., None] * along
        nearest = np.linalg.norm(place[:, None] - feet, axis=2).min(axis=1)
        self.assertLess(np.abs(distance.ravel() - nearest).max(), 1e-5)

    def test_fragments_are_those_of_the_mesh(self):
        result = craze.crack(plate(), "mud", seed=7, **KEEP)
        ids = result.bake(64, ["fragment"])["fragment"]
        wanted = 1 + result.mesh.face_attributes["fragment"].ravel()
        self.assertLessEqual(set(np.unique(ids)), set(np.unique(wanted)))

    def test_a_wider_gap_has_a_larger_mask(self):
        result = cracked()
        narrow, wide = (result.bake(64, "mask", gap=g)["mask"].sum() for g in (0.05, 0.1))
        self.assertLess(narrow, wide)

    def test_wrong_wishes_are_refused_with_a_reason(self):
        result = cracked()
        for wish in (
            dict(size=0),
            dict(size=9000),
            dict(maps=["masc"]),
            dict(maps=[]),
            dict(green="left"),
            dict(gap=-1),
        ):
            with self.assertRaises(craze.Error, msg=str(wish)) as caught:
                result.bake(**{"size": 16, **wish})
            self.assertEqual(caught.exception.kind, "usage")
        no_uvs = craze.crack((result.mesh.vertices, result.mesh.faces), "mud", max_cracks=1, **KEEP)
        with self.assertRaises(craze.Error) as caught:
            no_uvs.bake(16)
        self.assertIn("UVs", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
