"""benchmarks/transfer: measures by hand-made cases, lines, layouts of data sets, intervals. NumPy alone."""

import math
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

from small import SOURCE

sys.path.insert(0, str(SOURCE / "benchmarks" / "transfer"))
import baselines  # noqa: E402
import data  # noqa: E402
import lines  # noqa: E402
import metrics  # noqa: E402
import table  # noqa: E402


def stripe(top, height=3, length=40):
    """A band of rows of a 40 × 40 picture, from its left border."""
    mask = np.zeros((40, 40), bool)
    mask[top : top + height, :length] = True
    return mask


def measures(*pairs):
    tally = metrics.Tally()
    for found, true in pairs:
        tally.add(found, true)
    return tally.measures()


class Measures(unittest.TestCase):
    def test_a_mask_found_as_it_is_has_all_measures_at_their_best(self):
        got = measures((stripe(10), stripe(10)), (stripe(0, 0), stripe(0, 0)))
        for name in ("iou", "f1", "boundary_f1", "cl_iou", "cl_dice"):
            self.assertEqual(got[name], 1, name)
        self.assertEqual(got["false_on_clean"], 0)
        self.assertEqual(got["width_error"], 0)

    def test_nothing_found_is_zero_and_has_no_width(self):
        got = measures((stripe(0, 0), stripe(10)))
        for name in ("iou", "f1", "boundary_f1", "cl_iou", "cl_dice"):
            self.assertEqual(got[name], 0, name)
        self.assertTrue(math.isnan(got["width_error"]))
        self.assertTrue(math.isnan(got["false_on_clean"]))

    def test_a_line_beside_counts_up_to_the_tolerance(self):
        line = stripe(10, 1)
        near, far = measures((stripe(12, 1), line)), measures((stripe(13, 1), line))
        self.assertEqual((near["f1"], near["iou"]), (1, 0))
        self.assertEqual(far["f1"], 0)
        self.assertEqual(measures((stripe(14, 1), line))["cl_iou"], 1)
        self.assertEqual(measures((stripe(15, 1), line))["cl_iou"], 0)

    def test_half_of_a_line_has_the_f1_of_its_recall(self):
        half = np.zeros((40, 40), bool)
        half[10, :20] = True
        got = measures((half, stripe(10, 1)))
        self.assertEqual(got["iou"], 0.5)
        self.assertAlmostEqual(got["f1"], 2 * 0.55 / 1.55)  # 20 pixels and two within tolerance, of 40
        self.assertAlmostEqual(got["cl_dice"], 2 / 3)

    def test_counts_are_summed_over_the_pictures(self):
        got = measures((stripe(10), stripe(10)), (stripe(10, 1, 10), stripe(0, 0)))
        self.assertEqual(got["false_on_clean"], 10 / 1600)
        self.assertAlmostEqual(got["iou"], 120 / 130)

    def test_a_line_found_too_wide_has_that_error(self):
        self.assertEqual(measures((stripe(8, 7), stripe(10, 3)))["width_error"], 4)

    def test_the_distance_is_the_euclidean_one(self):
        mask = np.random.default_rng(1).uniform(size=(20, 25)) < 0.02
        y, x = np.nonzero(mask)
        rows, columns = np.mgrid[:20, :25]
        true = np.hypot(rows[..., None] - y, columns[..., None] - x).min(axis=2)
        got = metrics.distance_to(mask, 6)
        np.testing.assert_allclose(got[true <= 6], true[true <= 6])
        self.assertTrue(np.isinf(got[true > 6]).all())

    def test_a_bar_is_thinned_to_its_middle(self):
        thin = metrics.skeleton(stripe(10, 5))
        self.assertTrue((thin[:, 5:35].sum(axis=0) == 1).all())
        self.assertTrue(thin[12, 5:35].all())

    def test_thinning_keeps_a_ring_a_ring(self):
        rows, columns = np.mgrid[:40, :40]
        away = np.hypot(rows - 20, columns - 20)
        thin = metrics.skeleton((away > 8) & (away < 13))
        angles = np.arctan2(*(np.argwhere(thin) - 20).T)
        self.assertLess(np.diff(np.sort(angles)).max(), 0.2)
        self.assertFalse(thin[away < 7].any())


class Lines(unittest.TestCase):
    def test_a_line_covers_the_pixels_within_half_its_width(self):
        line = (np.array([[-5.0, 10.5], [45.0, 10.5]]), np.array([3.0, 3.0]))
        depth, side = lines.nearest([line], (40, 40))
        np.testing.assert_array_equal(lines.mask_of(depth), stripe(9))
        self.assertAlmostEqual(depth[15, 20], 5 - 1.5)
        self.assertAlmostEqual(side[15, 20], math.pi / 2)

    def test_lines_painted_again_look_as_they_were_measured(self):
        clean = np.random.default_rng(1).integers(120, 200, (40, 40, 3)).astype(np.uint8)
        line = (np.array([[-5.0, 10.5], [45.0, 10.5]]), np.array([5.0, 5.0]))
        depth, side = lines.nearest([line], (40, 40))
        light = lines.to_linear(clean)
        light[depth < 0] *= 0.2  # dark inside, and one flank in the shade
        light[(depth >= 0) & (depth < 2) & (side > 0)] *= 0.7
        picture = lines.to_srgb(light)
        got, mask = lines.paint(clean, [line], lines.appearance(picture, clean, [line]))
        np.testing.assert_array_equal(mask, stripe(8, 5))
        middle = np.s_[9:12]
        self.assertLess(np.abs(got[middle].astype(int) - picture[middle]).max(), 8)
        self.assertLess(np.abs(got[30:].astype(int) - clean[30:]).max(), 1)
        below, above = got[14].mean(), got[6].mean()
        self.assertLess(below / clean[14].mean(), 0.95)
        self.assertGreater(above / clean[6].mean(), 0.97)

    def test_length_is_counted_within_the_picture(self):
        line = (np.array([[-10.0, 5.0], [30.0, 5.0]]), np.ones(2))
        self.assertAlmostEqual(lines.length_within([line], (40, 20)), 20, delta=0.6)
        self.assertAlmostEqual(lines.area_within([line], (40, 20)), 20, delta=0.6)


class Baselines(unittest.TestCase):
    def test_a_voronoi_edge_lies_between_the_two_nearest_sites(self):
        sites = np.array([[0.0, 0.0], [10.0, 0.0], [5.0, 20.0], [5.0, -20.0]])
        ends = np.array(baselines._voronoi_edge(sites, 0, 1, 1000))
        np.testing.assert_allclose(ends[:, 0], 5)
        for end in ends:
            away = np.sort(np.hypot(*(sites - end).T))
            np.testing.assert_allclose(away[:3], away[0])
        self.assertIsNone(baselines._voronoi_edge(sites, 2, 3, 1000))

    def test_voronoi_edges_are_as_long_as_the_law_of_random_sites_says(self):
        random = np.random.default_rng(1)
        nets = [baselines.voronoi_lines(random, 100, 16, np.ones) for _ in range(8)]
        mean = np.mean([lines.length_within(net, (100, 100)) for net in nets])
        self.assertAlmostEqual(mean / (2 * math.sqrt(16) * 100), 1, delta=0.1)

    def test_walks_cover_what_is_asked(self):
        random = np.random.default_rng(1)
        drawn = baselines.walk_lines(random, 200, 2100.0, lambda n: np.full(n, 3.0), 20.0)
        area = lines.area_within(drawn, (200, 200))
        self.assertGreaterEqual(area, 2100)
        self.assertLess(area, 2100 * 1.1)
        for _, widths in drawn:
            self.assertEqual((widths[0], widths[-1]), (0, 0))


class Data(unittest.TestCase):
    def layout(self, *files):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        for file in files:
            path = Path(held.name, file)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.touch()
        return Path(held.name)

    def test_layouts_of_known_sets_are_understood(self):
        for picture, mask in (
            ("images/a.jpg", "masks/a.png"),
            ("test_img/a.jpg", "test_lab/a.png"),
            ("cfd_image/a.jpg", "seg_gt/a.png"),
            ("cfd_image/a.jpg", "groundTruth/a.mat"),
        ):
            folder = self.layout(picture, mask)
            self.assertEqual(data.pairs(folder), [(folder / picture, folder / mask)])

    def test_deepcrack_has_a_part_to_train_on(self):
        folder = self.layout("train_img/b.jpg", "train_lab/b.png", "test_img/a.jpg", "test_lab/a.png")
        self.assertEqual([p.stem for p, _ in data.pairs(folder, "train")], ["b"])
        self.assertEqual([p.stem for p, _ in data.pairs(folder, "test")], ["a"])

    def test_a_set_without_parts_is_split_into_two_that_share_nothing(self):
        folder = self.layout(*(f"{kind}/{k}.png" for kind in ("images", "masks") for k in range(8)))
        names = {part: [p.stem for p, _ in data.pairs(folder, part, split=True)] for part in
                 ("train", "test")}
        self.assertEqual(names, {"train": list("012456"), "test": list("37")})

    def test_a_picture_without_a_mask_is_named(self):
        with self.assertRaisesRegex(ValueError, "no mask for b.jpg"):
            data.pairs(self.layout("images/a.jpg", "images/b.jpg", "masks/a.png"))

    def test_an_unknown_layout_says_which_are_known(self):
        with self.assertRaisesRegex(ValueError, "known: images . masks"):
            data.pairs(self.layout("photos/a.jpg"))

    def test_squares_cover_the_picture(self):
        numbers = np.arange(40 * 50).reshape(40, 50)
        squares = list(data.tiles(np.dstack([numbers] * 3), numbers, 32))
        self.assertEqual(len(squares), 4)
        self.assertEqual(len(set(np.concatenate([m.ravel() for _, m in squares]))), 40 * 50)
        self.assertTrue(all(m.shape == (32, 32) and (p[..., 0] == m).all() for p, m in squares))


class Table(unittest.TestCase):
    def test_the_interval_is_students(self):
        mean, half = table.interval([1.0, 2.0, 3.0])
        self.assertEqual(mean, 2)
        self.assertAlmostEqual(half, 4.30 / math.sqrt(3))

    def test_the_table_goes_where_the_page_has_a_place_for_it(self):
        page = (SOURCE / "docs" / "transfer.md").read_text()
        filled = table.placed(page, "told")
        self.assertEqual(table.placed(filled, "told"), filled)
        self.assertIn(f"{table.MARKS[0]}\ntold\n{table.MARKS[1]}", filled)

    def test_intervals_that_lie_apart_have_a_verdict_either_way(self):
        self.assertEqual(table.verdict("f1", (0.9, 0.01), (0.8, 0.01)), "better")
        self.assertEqual(table.verdict("f1", (0.8, 0.01), (0.9, 0.01)), "worse")
        self.assertEqual(table.verdict("f1", (0.9, 0.06), (0.8, 0.06)), "overlap")
        self.assertEqual(table.verdict("width_error", (0.9, 0.01), (0.8, 0.01)), "worse")
