"""Lines on pictures: what craze, a Voronoi diagram and random walks put there, measured and painted
in one way. A line is (points, widths): (n, 2) and (n,), pixels, widths linear between points."""

import numpy as np

REACH = 12.0  # pixels from its edge beyond which a line leaves no trace
EDGES = np.array([-4, -3, -2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5, 2, 3, 4, 6, 8, REACH])
SIDES = 8  # directions in which a line's shading is told apart
ENOUGH = 20  # pixels, to know it in one


def nearest(lines, shape):
    """Of each pixel's centre the distance from the edge of the nearest line, negative inside, inf
    beyond REACH, and the direction from the line to it, radians."""
    depth, side = np.full(shape, np.inf), np.zeros(shape)
    for points, widths in lines:
        for k in range(len(points) - 1):
            _add_segment(depth, side, points[k], points[k + 1], widths[k] / 2, widths[k + 1] / 2)
    return depth, side


def _add_segment(depth, side, a, b, half_a, half_b):
    margin = REACH + max(half_a, half_b)
    low = np.maximum(np.floor(np.minimum(a, b) - margin), 0).astype(int)
    high = np.minimum(np.ceil(np.maximum(a, b) + margin), depth.shape[::-1]).astype(int)
    if (low >= high).any() or max(half_a, half_b) <= 0:
        return
    box = np.s_[low[1] : high[1], low[0] : high[0]]
    y, x = np.mgrid[box] + 0.5
    along = np.subtract(b, a)
    length = max(float(along @ along), 1e-12)
    t = np.clip(((x - a[0]) * along[0] + (y - a[1]) * along[1]) / length, 0, 1)
    dx, dy = x - a[0] - t * along[0], y - a[1] - t * along[1]
    half = half_a + t * (half_b - half_a)
    far = np.where(half > 0, np.hypot(dx, dy) - half, np.inf)
    closer = (far < depth[box]) & (far < REACH)
    depth[box] = np.where(closer, far, depth[box])
    side[box] = np.where(closer, np.arctan2(dy, dx), side[box])


def mask_of(depth):
    """Pixels that a line covers by about half or more."""
    return depth <= 0


def to_linear(picture):
    s = picture / 255.0
    return np.where(s <= 0.04045, s / 12.92, ((s + 0.055) / 1.055) ** 2.4)


def to_srgb(linear):
    curve = 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055
    s = np.where(linear <= 0.0031308, 12.92 * linear, curve)
    return np.clip(np.floor(255 * s + 0.5), 0, 255).astype(np.uint8)


def appearance(picture, clean, lines):
    """How the renderer drew these lines: the mean logarithm of light with them over light without,
    per direction, distance from the edge and colour. (SIDES, len(EDGES) − 1, 3)."""
    depth, side = nearest(lines, clean.shape[:2])
    at = np.isfinite(depth)
    change = np.log((to_linear(picture)[at] + 0.002) / (to_linear(clean)[at] + 0.002))
    bins = np.clip(np.searchsorted(EDGES, depth[at], "right") - 1, 0, len(EDGES) - 2)
    sector = _sector(side[at])
    every = _profile(change, bins, least=1)
    parts = [_profile(change[sector == s], bins[sector == s], ENOUGH) for s in range(SIDES)]
    return np.stack([every if part is None else part for part in parts])


def _profile(change, bins, least):
    """Means per bin; bins with fewer than `least` pixels are filled in from those beside. None where
    there are no others."""
    count = np.bincount(bins, minlength=len(EDGES) - 1)
    seen = np.flatnonzero(count >= least)
    if len(seen) == 0:
        return None
    means = [np.bincount(bins, change[:, c], len(EDGES) - 1)[seen] / count[seen] for c in range(3)]
    return np.stack([np.interp(np.arange(len(count)), seen, m) for m in means], axis=1)


def _sector(angle):
    return np.floor((angle + np.pi) / (2 * np.pi) * SIDES).astype(int) % SIDES


def paint(clean, lines, table):
    """The picture with these lines, looking as `appearance` found others to, and their mask."""
    depth, side = nearest(lines, clean.shape[:2])
    at = np.isfinite(depth)
    middles = (EDGES[1:] + EDGES[:-1]) / 2
    change, sector = np.zeros((at.sum(), 3)), _sector(side[at])
    for s in range(SIDES):
        for c in range(3):
            change[sector == s, c] = np.interp(depth[at][sector == s], middles, table[s, :, c])
    linear = to_linear(clean)
    linear[at] = (linear[at] + 0.002) * np.exp(change) - 0.002
    return to_srgb(np.clip(linear, 0, 1)), mask_of(depth)


def length_within(lines, shape):
    """Pixels of centre lines in a picture of `shape`."""
    return sum(length for points, widths in lines for length, _ in _pieces(points, widths, shape))


def area_within(lines, shape):
    """Pixels² that lines cover in a picture of `shape`, overlaps counted twice."""
    return sum(a * w for points, widths in lines for a, w in _pieces(points, widths, shape))


def _pieces(points, widths, shape):
    """Length within the picture, by points at most half a pixel apart, and width of each segment."""
    for k in range(len(points) - 1):
        a, b = points[k], points[k + 1]
        length = float(np.hypot(*(b - a)))
        count = max(1, int(np.ceil(2 * length)))
        t = (np.arange(count) + 0.5) / count
        x, y = a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])
        inside = (x >= 0) & (y >= 0) & (x < shape[1]) & (y < shape[0])
        yield length * inside.mean(), (widths[k] + widths[k + 1]) / 2
