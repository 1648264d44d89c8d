"""How well a mask was found. Masks are boolean arrays of one shape; needs NumPy alone.

A set is judged as a whole: each measure's counts are summed over its pictures (`Tally`), so that
pictures without a crack count too.
"""

import numpy as np

TOLERANCE = 2  # pixels, of F1 and of the boundaries
LINE_TOLERANCE = 4  # pixels, of clIoU


def distance_to(mask, farthest):
    """Euclidean distance from each pixel's centre to the nearest of the mask's, pixels; exact up to
    `farthest`, inf beyond it."""
    steps = range(-farthest, farthest + 1)
    down = _least([(_moved(mask, k, 0), k * k) for k in steps])
    squared = np.minimum.reduce([_moved(down, 0, k, np.inf) + k * k for k in steps])
    return np.sqrt(np.where(squared <= farthest * farthest, squared, np.inf))


def _least(parts):
    """Per pixel the least of the numbers whose mask has it."""
    return np.minimum.reduce([np.where(mask, number, np.inf) for mask, number in parts])


def _moved(values, down, right, outside=False):
    out = np.full_like(values, outside)
    height, width = values.shape
    out[max(0, down) : height + min(0, down), max(0, right) : width + min(0, right)] = values[
        max(0, -down) : height + min(0, -down), max(0, -right) : width + min(0, -right)
    ]
    return out


def near(mask, tolerance):
    """Pixels within `tolerance` pixels of the mask."""
    return distance_to(mask, tolerance) <= tolerance


def boundary(mask):
    """Pixels of the mask that touch, on one of four sides, what is not; the picture's border is no
    boundary."""
    padded = np.pad(mask, 1, mode="edge")
    inside = padded[:-2, 1:-1] & padded[2:, 1:-1] & padded[1:-1, :-2] & padded[1:-1, 2:]
    return mask & ~inside


def skeleton(mask):
    """The mask thinned to lines of one pixel (Zhang and Suen 1984), connected as the mask is."""
    thin = np.pad(mask, 1).astype(np.uint8)
    while True:
        before = thin.sum()
        for first in (True, False):
            p = _neighbours(thin)
            count = sum(p)
            turns = sum((a == 0) & (b == 1) for a, b in zip(p, p[1:] + p[:1]))
            north, east, south, west = p[0], p[2], p[4], p[6]
            if first:
                ends = (north * east * south == 0) & (east * south * west == 0)
            else:
                ends = (north * east * west == 0) & (north * south * west == 0)
            core = thin[1:-1, 1:-1]
            core[(core == 1) & (count >= 2) & (count <= 6) & (turns == 1) & ends] = 0
        if thin.sum() == before:
            return thin[1:-1, 1:-1].astype(bool)


def _neighbours(padded):
    """The eight neighbours of each pixel, clockwise from the north."""
    rows = {-1: np.s_[:-2], 0: np.s_[1:-1], 1: np.s_[2:]}
    ring = [(-1, 0), (-1, 1), (0, 1), (1, 1), (1, 0), (1, -1), (0, -1), (-1, -1)]
    return [padded[rows[y], rows[x]].copy() for y, x in ring]


def ratio(part, whole):
    return part / whole if whole > 0 else float("nan")


def harmonic(a, b):
    return 2 * a * b / (a + b) if a + b > 0 else 0.0


class Tally:
    """Sums over the pictures of a set."""

    def __init__(self):
        self.sums = dict.fromkeys(
            "both either found true found_near true_near edge_found edge_true edge_found_near "
            "edge_true_near line_found line_true line_found_near line_true_near line_found_in "
            "line_true_in clean_found clean_pixels width_errors width_pixels".split(),
            0.0,
        )

    def add(self, found, true):
        """A picture's mask as it was found and as it is."""
        s = self.sums
        lines_found, lines_true = skeleton(found), skeleton(true)
        edges_found, edges_true = boundary(found), boundary(true)
        s["both"] += (found & true).sum()
        s["either"] += (found | true).sum()
        self._add("", found, true, TOLERANCE)
        self._add("edge_", edges_found, edges_true, TOLERANCE)
        self._add("line_", lines_found, lines_true, LINE_TOLERANCE)
        s["line_found_in"] += (lines_found & true).sum()
        s["line_true_in"] += (lines_true & found).sum()
        if not true.any():
            s["clean_found"] += found.sum()
            s["clean_pixels"] += found.size
        self._add_widths(found, true, lines_true)

    def _add(self, kind, found, true, tolerance):
        s = self.sums
        s[kind + "found"] += found.sum()
        s[kind + "true"] += true.sum()
        s[kind + "found_near"] += (found & near(true, tolerance)).sum()
        s[kind + "true_near"] += (true & near(found, tolerance)).sum()

    def _add_widths(self, found, true, lines_true):
        """On the true centre lines: twice the distance to what is no crack, less one pixel; the
        found width where the mask has the line."""
        at = lines_true & found
        self.sums["width_pixels"] += at.sum()
        if at.any():
            error = width_at(found, at) - width_at(true, at)
            self.sums["width_errors"] += np.abs(error).sum()

    def measures(self):
        """Shares of 1, but `width_error`, pixels. nan: nothing to measure."""
        s = self.sums
        matched = (s["line_found_near"] + s["line_true_near"]) / 2
        missed = s["line_found"] - s["line_found_near"] + s["line_true"] - s["line_true_near"]
        return {
            "iou": ratio(s["both"], s["either"]),
            "f1": self._f1(""),
            "boundary_f1": self._f1("edge_"),
            "cl_iou": ratio(matched, matched + missed),
            "cl_dice": harmonic(
                ratio(s["line_found_in"], s["line_found"]) if s["line_found"] else 0.0,
                ratio(s["line_true_in"], s["line_true"]),
            ),
            "false_on_clean": ratio(s["clean_found"], s["clean_pixels"]),
            "width_error": ratio(s["width_errors"], s["width_pixels"]),
        }

    def _f1(self, kind):
        s = self.sums
        if s[kind + "true"] == 0:
            return float("nan")
        precision = s[kind + "found_near"] / s[kind + "found"] if s[kind + "found"] else 0.0
        return harmonic(precision, s[kind + "true_near"] / s[kind + "true"])


def width_at(mask, at, widest=16):
    """Widths of a mask at some of its pixels, pixels: twice the distance to the nearest pixel that
    is not in it, less one; at most 2 · `widest` − 1."""
    away = np.minimum(distance_to(~mask, widest), widest)
    return 2 * away[at] - 1
