"""Labels of datasets, against the geometry projected here, with NumPy alone."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import craze.dataset
from small import COMMAND

PLATE = """
samples = 3
clean = 0
points = 20000
width = 160
height = 144
[object]
mesh = "shape:plate?n=24&jitter=0.3"
[recipe]
preset = "mud"
mesh.edge = "keep"
layer.relative_spacing = 0.2
[lines]
width = {log_uniform = [2, 8]}
unevenness = 0.2
[camera]
elevation = {uniform = [50, 90]}
azimuth = {uniform = [0, 360]}
zoom = 2
"""
SPHERE = PLATE.replace("plate?n=24&jitter=0.3", "sphere?n=24").replace("zoom = 2", "zoom = 0.9")


def made(plan):
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "plan.toml").write_text(plan, encoding="utf-8")
        subprocess.run([COMMAND, "dataset", "plan.toml", "-o", "set", "--quiet"], cwd=folder,
                       check=True)
        return list(craze.dataset.samples(Path(folder, "set")))


class NoSet(unittest.TestCase):
    def test_is_an_error_and_no_empty_one(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(FileNotFoundError):
            next(craze.dataset.samples(folder))


class HalfGrown(unittest.TestCase):
    def test_set_gives_the_samples_that_are_there(self):
        plan = PLATE.replace("samples = 3", "samples = 3\nshard_samples = 2")
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "plan.toml").write_text(plan, encoding="utf-8")

            def there(*more):
                subprocess.run([COMMAND, "dataset", "plan.toml", "-o", "set", "--quiet", *more],
                               cwd=folder, check=True)
                return [s["json"]["index"] for s in craze.dataset.samples(Path(folder, "set"))]

            self.assertEqual(there(), [0, 1, 2])
            self.assertEqual(there("--samples", "7", "--shard", "3/4"), [0, 1, 2, 6])
            self.assertEqual(there("--samples", "7"), list(range(7)))


def projected(camera, points):
    """Pixels and depths of points: K [R | t]."""
    matrix = np.array(camera["world_to_camera"])
    x, y, z = (points @ matrix[:, :3].T + matrix[:, 3]).T
    return np.stack([camera["fx"] * x / z + camera["cx"], camera["fy"] * y / z + camera["cy"]],
                    axis=1), z


def segments(sample):
    """Ends and widths of all straight pieces of the centre lines: (n, 2, 3), (n, 2)."""
    ends, widths = [], []
    for crack in sample["json"]["cracks"]:
        points, width = np.array(crack["points"]), np.array(crack["width"])
        ends.append(np.stack([points[:-1], points[1:]], axis=1))
        widths.append(np.stack([width[:-1], width[1:]], axis=1))
    return np.concatenate(ends), np.concatenate(widths)


def on_plate(camera, pixels):
    """Where rays through pixels meet z = 0."""
    matrix = np.array(camera["world_to_camera"])
    turn, eye = matrix[:, :3], -matrix[:, :3].T @ matrix[:, 3]
    rays = np.stack([(pixels[:, 0] - camera["cx"]) / camera["fx"],
                     (pixels[:, 1] - camera["cy"]) / camera["fy"],
                     np.ones(len(pixels))], axis=1) @ turn
    return (eye - eye[2] / rays[:, 2:] * rays)[:, :2]


def bars(sample):
    """Per piece and end: the direction of an older crack that its crack ends on there, or nan."""
    cracks = sample["json"]["cracks"]
    through = {}
    for crack in cracks:
        points = np.array(crack["points"])
        for before, point, after in zip(points[:-2], points[1:-1], points[2:]):
            through[tuple(point)] = after - before
    found = []
    for crack in cracks:
        of_crack = np.full((len(crack["points"]) - 1, 2, 2), np.nan)
        for piece, end, point in ((0, 0, crack["points"][0]), (-1, 1, crack["points"][-1])):
            if tuple(point) in through:
                of_crack[piece, end] = through[tuple(point)][:2]
        found.append(of_crack)
    return np.concatenate(found)


def nearest(places, ends, widths, bars, near=np.inf):
    """Per place the distance from the edge of the nearest strip, its piece and where on it; pieces
    farther than `near` from the first place of a row do not count. A crack that ends on another
    does not reach across it. Places: (n, k, 2); what comes out: (n, k)."""
    best = np.full(places.shape[:2], np.inf)
    piece, share = np.zeros(best.shape, int), np.zeros(best.shape)
    for i, (end, width, bar) in enumerate(zip(ends[..., :2], widths, bars)):
        along = end[1] - end[0]
        reach = np.linalg.norm(along) / 2 + near
        rows = np.nonzero(np.linalg.norm(places[:, 0] - end.mean(axis=0), axis=1) < reach)[0]
        here = places[rows]
        t = np.clip((here - end[0]) @ along / (along @ along), 0, 1)
        half = (width[0] + t * (width[1] - width[0])) / 2
        outside = np.linalg.norm(here - end[0] - t[..., None] * along, axis=-1) - half
        nearer = (outside < best[rows]) & (half > 0)
        for k in (0, 1):
            if np.isfinite(bar[k]).all():
                across = np.array([-bar[k][1], bar[k][0]])
                own = np.sign((end[1 - k] - end[k]) @ across)
                nearer &= (t != k) | (own * ((here - end[k]) @ across) >= 0)
        best[rows] = np.where(nearer, outside, best[rows])
        piece[rows] = np.where(nearer, i, piece[rows])
        share[rows] = np.where(nearer, t, share[rows])
    return best, piece, share


@unittest.skipUnless(COMMAND, "no command")
class Plate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.samples = made(PLATE)

    def test_centre_lines_are_where_their_points_are_seen(self):
        for sample in self.samples:
            for crack in sample["json"]["cracks"]:
                seen, _ = projected(sample["json"]["camera"], np.array(crack["points"]))
                off = np.abs(seen - np.array(crack["pixels"])).max()
                self.assertLess(off, 1e-3)

    def test_masks_are_coverage_of_a_half(self):
        border = wrong = 0
        steps = (np.arange(20) + 0.5) / 20
        fine = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
        for sample in self.samples:
            camera, mask = sample["json"]["camera"], sample["mask"].ravel()
            strips = (*segments(sample), bars(sample))
            rows, columns = np.indices(sample["mask"].shape).reshape(2, -1)
            corners = np.stack([columns, rows], axis=1)
            outside = nearest(on_plate(camera, corners + 0.5)[:, None], *strips)[0][:, 0]
            step = on_plate(camera, np.array([[80, 72], [81, 72], [80, 73.0]]))
            pixel = np.linalg.norm(step[1:] - step[0], axis=1).max()
            self.assertFalse((mask[outside > 2 * pixel] > 0).any())
            near = np.abs(outside) < 1.5 * pixel
            places = on_plate(camera, (corners[near, None] + fine).reshape(-1, 2))
            reach = 3 * pixel + strips[1].max()
            inside = nearest(places.reshape(near.sum(), -1, 2), *strips, reach)[0] < 0
            coverage = inside.mean(axis=1)
            is_border = (coverage > 0) & (coverage < 1)
            border += is_border.sum()
            sure = np.abs(coverage - 0.5) > 0.005  # what 400 points can tell
            wrong += (((mask[near] > 0) != (coverage >= 0.5)) & sure & is_border).sum()
            off = np.abs(sample["coverage"].ravel()[near] - coverage)
            self.assertLess(np.quantile(off, 0.99), 0.02)
        self.assertGreater(border, 2000)
        self.assertLess(wrong, 0.005 * border, f"{wrong} of {border}")

    def test_widths_are_those_seen_across_the_line(self):
        off_by_more = compared = 0
        for sample in self.samples:
            camera = sample["json"]["camera"]
            ends, widths = segments(sample)
            rows, columns = np.nonzero(sample["coverage"] > 0.6)
            centres = np.stack([columns, rows], axis=1) + 0.5
            outside, piece, share = (
                a[:, 0] for a in nearest(on_plate(camera, centres)[:, None], ends, widths,
                                         bars(sample)))
            keep = outside < 0
            piece, t = piece[keep], share[keep, None]
            width = widths[piece, 0] + t[:, 0] * (widths[piece, 1] - widths[piece, 0])
            along = ends[piece, 1] - ends[piece, 0]
            along /= np.linalg.norm(along, axis=1, keepdims=True)
            middle = ends[piece, 0] + t * (ends[piece, 1] - ends[piece, 0])
            across = np.stack([-along[:, 1], along[:, 0], 0 * t[:, 0]], axis=1)
            left, _ = projected(camera, middle + across * width[:, None] / 2)
            right, _ = projected(camera, middle - across * width[:, None] / 2)
            step, _ = projected(camera, middle + 1e-6 * along)
            back, _ = projected(camera, middle - 1e-6 * along)
            line = (step - back) / np.linalg.norm(step - back, axis=1, keepdims=True)
            gap = left - right
            seen = np.abs(gap[:, 0] * line[:, 1] - gap[:, 1] * line[:, 0])
            given = sample["width"][rows[keep], columns[keep]]
            off = np.abs(given - seen) / np.maximum(0.1, 0.02 * seen)
            off_by_more += (off > 1).sum()
            compared += len(off)
            self.assertLess(np.quantile(off, 0.99), 0.1)
            self.assertLess(np.abs(given - seen).max(), 0.5)
        self.assertGreater(compared, 2000)
        # Beside pixels where a crack ends on another: there a piece may be the next one.
        self.assertLess(off_by_more, 0.002 * compared)

    def test_distances_and_depths_are_those_of_the_plate(self):
        for sample in self.samples:
            camera = sample["json"]["camera"]
            rows, columns = np.indices(sample["mask"].shape).reshape(2, -1)
            centres = np.stack([columns, rows], axis=1) + 0.5
            there = np.isfinite(sample["depth"].ravel())
            points = on_plate(camera, centres[there])
            _, depth = projected(camera, np.column_stack([points, np.zeros(len(points))]))
            self.assertLess(np.abs(depth / sample["depth"].ravel()[there] - 1).max(), 1e-4)
            best = np.full(len(centres), 63.0)
            for crack in sample["json"]["cracks"]:
                p, v = np.array(crack["pixels"]), np.array(crack["visible"])
                for a, b in zip(p[:-1][(v[:-1] & v[1:]) > 0], p[1:][(v[:-1] & v[1:]) > 0]):
                    t = np.clip((centres - a) @ (b - a) / max((b - a) @ (b - a), 1e-30), 0, 1)
                    best = np.minimum(best, np.linalg.norm(centres - a - t[:, None] * (b - a),
                                                           axis=1))
            self.assertLess(np.abs(best - sample["distance"].ravel()).max(), 0.01)

    def test_cracks_are_numbered_as_they_opened_and_end_on_older_ones(self):
        for sample in self.samples:
            cracks = {c["id"]: c for c in sample["json"]["cracks"]}
            times = [cracks[i]["time"] for i in sorted(cracks)]
            self.assertEqual(times, sorted(times))
            parents = [c["parent"] for c in cracks.values() if c["parent"] is not None]
            self.assertGreater(len(parents), 0)
            self.assertTrue(all(c["parent"] is None or c["parent"] < c["id"]
                                for c in cracks.values()))
            shown = set(np.unique(sample["crack"])) - {0}
            self.assertTrue(shown <= set(cracks))
            kinds = {j["kind"] for j in sample["json"]["junctions"]}
            self.assertTrue(kinds <= {"end", "border", "t", "y", "x", "other"})
            self.assertIn("t", kinds)


@unittest.skipUnless(COMMAND, "no command")
class Sphere(unittest.TestCase):
    def test_what_the_far_side_has_is_hidden(self):
        hidden = 0
        for sample in made(SPHERE):
            camera = sample["json"]["camera"]
            matrix = np.array(camera["world_to_camera"])
            eye = -matrix[:, :3].T @ matrix[:, 3]
            for crack in sample["json"]["cracks"]:
                points = np.array(crack["points"])
                outward = points / np.linalg.norm(points, axis=1, keepdims=True)
                view = eye - points
                facing = np.sum(outward * view, axis=1) / np.linalg.norm(view, axis=1)
                seen, _ = projected(camera, points)
                inside = ((seen > 0) & (seen < [160, 144])).all(axis=1)
                visible = np.array(crack["visible"]) > 0
                # The body has flat faces: near its outline either may be.
                self.assertTrue(visible[inside & (facing > 0.25)].all())
                self.assertFalse(visible[facing < -0.25].any())
                self.assertFalse(visible[~inside].any())
                hidden += (facing < -0.25).sum()
        self.assertGreater(hidden, 100)


def fields(cloud, *names):
    return np.stack([cloud[name].astype(float) for name in names], axis=-1)


@unittest.skipUnless(COMMAND, "no command")
class Points(unittest.TestCase):
    """Clouds, against the geometry of the JSON and the pictures."""

    @classmethod
    def setUpClass(cls):
        cls.samples = made(PLATE.replace("zoom = 2", "zoom = 3.2"))

    def test_lie_on_the_surface_where_the_picture_shows_it_with_its_colour(self):
        for sample in self.samples:
            cloud, camera = sample["points"], sample["json"]["camera"]
            self.assertEqual(len(cloud), 20000)  # the picture is full
            self.assertLess(np.abs(cloud["z"]).max(), 1e-9)
            seen, _ = projected(camera, fields(cloud, "x", "y", "z"))
            columns, rows = np.floor(seen).astype(int).T
            inside = np.abs(seen - np.round(seen)).min(axis=1) > 1e-3  # of a pixel
            colours = sample["image"][rows[inside], columns[inside]]
            np.testing.assert_array_equal(colours,
                                          fields(cloud[inside], "red", "green", "blue"))
            normals = fields(cloud, "nx", "ny", "nz")
            self.assertLess(np.abs(normals - [0, 0, 1]).max(), 1e-6)

    def test_are_spread_evenly_and_so_are_the_first_of_them(self):
        for sample in self.samples:
            seen, _ = projected(sample["json"]["camera"], fields(sample["points"], "x", "y", "z"))
            for count in (500, 20000):
                cells = np.histogram2d(*seen[:count].T, bins=(8, 8),
                                       range=((0, 160), (0, 144)))[0]
                # 64 cells; thrown at random they would differ by five times the root.
                self.assertLess(np.abs(cells - count / 64).max(), 2 + 0.5 * (count / 64) ** 0.5)

    def test_have_the_crack_the_width_and_the_distance_that_the_lines_give(self):
        wrong = compared = 0
        for sample in self.samples:
            cloud = sample["points"]
            strips = (*segments(sample), bars(sample))
            places = fields(cloud, "x", "y")
            outside, piece, share = (a[:, 0] for a in nearest(places[:, None], *strips))
            sure = np.abs(outside) > 1e-6
            ids = np.concatenate([[c["id"]] * (len(c["points"]) - 1)
                                  for c in sample["json"]["cracks"]])
            cracked = outside < 0
            wrong += (((cloud["crack"] > 0) != cracked) & sure).sum()
            np.testing.assert_array_equal(cloud["mask"], cloud["crack"] > 0)
            same = cracked & (cloud["crack"] == ids[piece])
            # Where two strips cover a place either may be nearer, but for rounding.
            self.assertGreater(same.sum(), 0.98 * cracked.sum())
            width = strips[1][piece, 0] + share * (strips[1][piece, 1] - strips[1][piece, 0])
            self.assertLess(np.abs(cloud["width"] - width)[same].max(), 1e-3 * width[same].max())
            self.assertEqual(cloud["width"][cloud["crack"] == 0].max(), 0)
            compared += cracked.sum()
            farthest = sample["json"]["label"]["points_farthest"]
            best = np.full(len(cloud), farthest)
            for a, b in strips[0][..., :2]:
                t = np.clip((places - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
                best = np.minimum(best, np.linalg.norm(places - a - t[:, None] * (b - a), axis=1))
            seen, _ = projected(sample["json"]["camera"], fields(cloud, "x", "y", "z"))
            # Near the frame a crack may be nearest that it does not show.
            inner = (np.abs(seen - [80, 72]) < [50, 42]).all(axis=1)
            self.assertGreater(inner.sum(), 5000)
            off = (cloud["distance"] - best)[inner]
            self.assertGreaterEqual(off.min(), -1e-5 * farthest)
            # Along the surface: a crack lies in the way of some.
            self.assertGreater((off < 1e-5 * farthest).mean(), 0.99)
        self.assertGreater(compared, 1000)
        self.assertLess(wrong, 0.002 * compared, f"{wrong} of {compared}")

    def test_have_the_fragment_that_the_picture_has_there(self):
        for sample in self.samples:
            cloud = sample["points"]
            seen, _ = projected(sample["json"]["camera"], fields(cloud, "x", "y", "z"))
            columns, rows = np.floor(seen).astype(int).T
            there = sample["fragment"][rows, columns]
            self.assertGreater((there == cloud["fragment"]).mean(), 0.97)
            self.assertGreater(len(np.unique(cloud["fragment"])), 1)

    def test_keep_what_is_there_where_the_mask_has_label_noise(self):
        one = PLATE.replace("samples = 3", "samples = 1")
        for noise, fewer in (("dropout = 0.5", True), ("grow = 2", False)):
            for sample in made(f"{one}[label]\n{noise}\n"):
                mask, crack = sample["points"]["mask"] > 0, sample["points"]["crack"] > 0
                self.assertGreater(crack.sum(), 100)
                self.assertTrue((mask <= crack if fewer else mask >= crack).all())
                self.assertNotEqual(mask.sum(), crack.sum())

    def test_of_a_body_are_those_that_the_camera_sees(self):
        for sample in made(SPHERE):
            cloud, camera = sample["points"], sample["json"]["camera"]
            self.assertLess(len(cloud), 20000)  # beside it is nothing
            self.assertGreater(len(cloud), 2000)
            places, normals = fields(cloud, "x", "y", "z"), fields(cloud, "nx", "ny", "nz")
            matrix = np.array(camera["world_to_camera"])
            eye = -matrix[:, :3].T @ matrix[:, 3]
            rays = places - eye
            self.assertLess(((rays * normals).sum(axis=1)).max(), 1e-3)
            _, depth = projected(camera, places)
            middle = projected(camera, np.zeros((1, 3)))[1][0]
            self.assertLess(depth.max(), middle)
            self.assertLess(np.abs(np.linalg.norm(places, axis=1) - 1).max(), 0.01)


if __name__ == "__main__":
    unittest.main()
