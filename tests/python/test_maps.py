"""Maps from Python."""

import json
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

    def test_curl_of_the_recipe_lifts_rims(self):
        flat, curled = (
            craze.crack(plate(), "mud", seed=7, **KEEP, **{"post.gap": 0.05, "post.curl": curl})
            .bake(64, ["height"])["height"]
            for curl in (0, 2)
        )
        self.assertEqual(flat.max(), 0)
        self.assertGreater(curled.max(), 0)

    def test_the_description_has_a_file_for_each_map(self):
        maps = cracked().bake(24, ["normal", "crack"], "down")
        described = json.loads(maps.description)
        self.assertEqual(described["format"], "exr")
        for name, said in zip(maps, described["maps"]):
            self.assertEqual((said["file"], said["map"]), (f"{name}.exr", name))
            self.assertEqual(said["size"], [24, 24])
        self.assertEqual(described["maps"][0]["green"], "down")
        self.assertEqual(described["maps"][1]["range"][1], maps["crack"].max())

    def test_what_maps_do_not_show_is_said(self):
        whole = craze.crack(plate(), "mud", seed=7, max_cracks=0, **KEEP)
        with self.assertWarnsRegex(UserWarning, "no cracks"):
            whole.bake(16, ["mask"])

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


class Textures(Case):
    def test_all_are_arrays_by_name(self):
        maps = craze.texture("mud", 24, **{"layer.spacing": 0.2})
        self.assertEqual(
            set(maps), set("base_color normal height occlusion roughness mask fragment".split())
        )
        for name, values in maps.items():
            color = name in ("normal", "base_color")
            self.assertEqual(values.shape, (24, 24, 3) if color else (24, 24), name)
            self.assertTrue(np.isfinite(values).all(), name)

    def test_the_period_is_a_scale(self):
        """A tile of 40 cm has the pattern of one of 40 units, and heights 100 times less."""
        wide = craze.texture("mud", 24, 40.0, ["height"], seed=1)["height"]
        small = craze.texture("mud", 24, "40cm", ["height"], seed=1)["height"]
        self.assertLess(wide.min(), 0)
        np.testing.assert_allclose(small, wide / 100, rtol=1e-5, atol=1e-7)

    def test_the_description_says_what_the_tile_is(self):
        maps = craze.texture("mud", 24, "40cm", ["mask"], seed=3)
        tile = json.loads(maps.description)["tile"]
        self.assertEqual((tile["side"], tile["seed"]), (0.4, 3))

    def test_seeds_differ_and_repeat(self):
        first, again, other = (
            craze.texture("mud", 16, maps="mask", seed=s)["mask"] for s in (1, 1, 2)
        )
        np.testing.assert_array_equal(first, again)
        self.assertFalse(np.array_equal(first, other))

    def test_wrong_wishes_are_refused_with_a_reason(self):
        for wish, words in (
            (dict(size=0), "size"),
            (dict(period=0), "period"),
            (dict(period="3%"), "period"),
            (dict(period=float("nan")), "period"),
            (dict(period=[1]), "period"),
            (dict(maps=["position"]), "position"),
            (dict(maps=["stones"]), "stones"),
            (dict(green="left"), "green"),
            (dict(recipe="custard"), "custard"),
            ({"layer.spacing": 0.5}, "quarter"),
            ({"where.materials": ["a"]}, "material"),
        ):
            with self.assertRaisesRegex(craze.Error, words):
                craze.texture(**wish)

    def test_what_a_progress_function_raises_comes_out(self):
        def stop(*_):
            raise KeyError("enough")

        with self.assertRaises(KeyError):
            craze.texture("mud", 16, progress=stop)


if __name__ == "__main__":
    unittest.main()
