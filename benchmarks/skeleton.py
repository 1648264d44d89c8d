"""A crack pattern as a photograph's skeleton would show it: lines one pixel wide, thinned."""

import math

AROUND = ((0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1))


def pixels_of(lines, size):
    """The pixels, of that size in model units, that planar lines run through."""
    pixels, points = set(), lines["points"]
    for a, b in lines["edges"]:
        (x, y), (u, v) = [[c / size for c in points[p][:2]] for p in (a, b)]
        steps = 1 + int(2 * max(abs(u - x), abs(v - y)))
        for i in range(steps + 1):
            t = i / steps
            pixels.add((math.floor(x + t * (u - x)), math.floor(y + t * (v - y))))
    return pixels


def thinned(pixels):
    """Their skeleton (Zhang & Suen 1984)."""
    pixels = set(pixels)
    while True:
        before = len(pixels)
        for sides in (((0, 2, 4), (2, 4, 6)), ((0, 2, 6), (0, 4, 6))):
            gone = []
            for x, y in pixels:
                near = [(x + i, y + j) in pixels for i, j in AROUND]
                if not 2 <= sum(near) <= 6:
                    continue
                rises = sum(not near[i] and near[(i + 1) % 8] for i in range(8))
                if rises == 1 and not any(all(near[i] for i in side) for side in sides):
                    gone.append((x, y))
            pixels.difference_update(gone)
        if len(pixels) == before:
            return pixels


def skeleton_graph(lines, size):
    """Points and edges for `craze stats`, in pixels: neighbours by a side, or by a corner where no
    side leads around it."""
    pixels = thinned(pixels_of(lines, size))
    index = {p: i for i, p in enumerate(sorted(pixels))}
    edges = []
    for x, y in index:
        for i, j in ((1, 0), (0, 1), (1, 1), (1, -1)):
            beside = i and j and ((x + i, y) in index or (x, y + j) in index)
            if (x + i, y + j) in index and not beside:
                edges.append((index[x, y], index[x + i, y + j]))
    return {"points": [(x, y, 0) for x, y in index], "edges": edges}
