"""The patterns that people draw instead: edges of Voronoi cells, and random walks that branch.

Both get what a sample of ours has: the same surface, lamp and marks, as much area
of lines, the same widths, and the looks that the renderer gave the cracks of that very sample
(lines.appearance).
Only where the lines run differs.

    python3 baselines.py sets arms
"""

import argparse
import importlib.util
import os
from multiprocessing import Pool
from pathlib import Path

import numpy as np

from data import write_pair
from lines import appearance, area_within, length_within, paint

BINDINGS = Path(__file__).resolve().parents[2] / "bindings" / "python" / "craze" / "dataset.py"
ARMS = ("craze", "craze_painted", "voronoi", "walks")
ENOUGH = 0.1  # relative, of areas that are to be alike
STEP = 4.0  # pixels, of a walk


def voronoi_lines(random, size, count, width_of):
    """The edges of `count` Voronoi cells per picture of size², seeds also beyond its border."""
    span = 2 * size
    sites = random.uniform(-span / 4, span * 3 / 4, (max(3, round(4 * count)), 2))
    lines = []
    for i in range(len(sites)):
        for j in range(i + 1, len(sites)):
            ends = _voronoi_edge(sites, i, j, span)
            if ends is not None:
                lines.append((np.array(ends), width_of(2)))
    return lines


def _voronoi_edge(sites, i, j, reach):
    """Where sites i and j are the nearest two: the ends of a part of their bisector, or None."""
    middle = (sites[i] + sites[j]) / 2
    across = sites[j] - sites[i]
    along = np.array([-across[1], across[0]]) / np.hypot(*across)
    others = np.delete(sites, [i, j], axis=0)
    # |middle + t along − other|² ≥ |… − sites[i]|² is linear in t
    slope = 2 * (sites[i] - others) @ along
    level = ((others - middle) ** 2).sum(axis=1) - ((sites[i] - middle) ** 2).sum()
    bound = -level / np.where(slope == 0, 1e-12, slope)
    low = max([-reach, *bound[slope > 0]])
    high = min([reach, *bound[slope < 0]])
    return (middle + low * along, middle + high * along) if low < high else None


def walk_lines(random, size, area, width_of, taper):
    """Walks with headings that drift, some with branches, until there is enough within the picture."""
    lines, left = [], area
    while left > 0:
        heading = random.uniform(0, 2 * np.pi)
        lines.append(_walk(random, random.uniform(0, size, 2), heading, left, size, width_of, taper))
        left -= area_within(lines[-1:], (size, size))
        while left > 0 and random.uniform() < 0.5:
            points = lines[-1][0]
            at = random.integers(len(points))
            turn = heading + random.choice([-1, 1]) * random.uniform(0.4, 1.3)
            lines.append(_walk(random, points[at], turn, left, size, width_of, taper))
            left -= area_within(lines[-1:], (size, size))
    return lines


def _walk(random, start, heading, most, size, width_of, taper):
    """One walk; it ends where its area passes `most`."""
    points = [np.asarray(start)]
    for _ in range(int(random.uniform(0.3, 1.5) * size / STEP)):
        heading += random.normal(0, 0.3)
        points.append(points[-1] + STEP * np.array([np.cos(heading), np.sin(heading)]))
    widths = width_of(len(points))
    count = max(3, int(np.searchsorted(np.cumsum(STEP * widths), most)) + 1)
    points, widths = points[:count], widths[:count]
    way = STEP * np.arange(len(points))
    closing = np.sqrt(np.clip(np.minimum(way, way[::-1]) / taper, 0, 1))
    return np.array(points), widths * closing


def widths_like(random, lines, shape, unevenness):
    """Draws a line's widths: a mean that one of `lines` has, by length, and smooth unevenness."""
    lengths = np.array([length_within([line], shape) for line in lines])
    means = np.array([np.average(line[1], weights=_shares(line[0])) for line in lines])

    def draw(count):
        mean = random.choice(means, p=lengths / lengths.sum())
        rough = random.normal(0, 1, count + 4)
        smooth = np.convolve(rough, np.ones(5) / np.sqrt(5), "valid")
        return mean * np.maximum(0.2, 1 + 0.6 * unevenness * smooth)

    return draw


def _shares(points):
    steps = np.hypot(*np.diff(points, axis=0).T)
    return np.maximum(np.append(steps, 0) + np.insert(steps, 0, 0), 1e-9)


def closest(draws, area, shape):
    """The first of the drawn nets that covers what is asked, within ENOUGH, or else the nearest."""
    best, miss = [], np.inf
    for lines in draws:
        off = abs(area_within(lines, shape) - area) / area
        if off < miss:
            best, miss = lines, off
        if miss <= ENOUGH:
            break
    return best


def own_lines(facts):
    """The centre lines of a sample's JSON, those parts that are seen."""
    lines = []
    for crack in facts["cracks"]:
        points, widths = np.array(crack["pixels"], float), np.array(crack["width_pixels"], float)
        seen = np.array(crack["visible"], bool)
        seen[:-1] |= np.array(crack["visible"][1:], bool)  # up to the border of the picture
        seen[1:] |= np.array(crack["visible"][:-1], bool)
        for part in np.split(np.arange(len(seen)), np.flatnonzero(np.diff(seen)) + 1):
            if seen[part[0]] and len(part) > 1:
                lines.append((points[part], widths[part]))
    return lines


def versions(sample, clean, seed):
    """A sample's picture and mask as each arm has it."""
    picture, facts, shape = sample["image"], sample["json"], sample["mask"].shape
    mask, lines = sample["mask"] > 0, own_lines(facts)
    made = {"craze": (picture, mask)}
    length, area = length_within(lines, shape), area_within(lines, shape)
    if facts["clean"] or length < STEP:
        return dict.fromkeys(ARMS, (picture, mask))
    random, size = np.random.default_rng(seed), shape[0]
    table = appearance(picture, clean["image"], lines)
    width_of = widths_like(random, lines, shape, facts["values"]["lines.unevenness"])
    cells = (length / (2 * size)) ** 2  # the expected length of a picture's edges is 2 size √cells
    nets = (voronoi_lines(random, size, cells, width_of) for _ in range(40))
    others = {
        "craze_painted": lines,
        "voronoi": closest(nets, area, shape),
        "walks": walk_lines(random, size, area, width_of, facts["values"]["lines.taper"]),
    }
    for arm, drawn in others.items():
        made[arm] = paint(clean["image"], drawn, table)
    return made


def package():
    """craze.dataset, which needs no more than NumPy, without the rest of the package."""
    spec = importlib.util.spec_from_file_location("craze_dataset", BINDINGS)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def pairs_of(sets):
    """Samples with and without their cracks: (name, seed, sample, clean sample)."""
    samples = package().samples
    for number, cracks in enumerate(sorted(sets.glob("*_cracks"))):
        world = cracks.name.removesuffix("_cracks")
        cleans = samples(sets / f"{world}_clean")
        clean = next(cleans, None)
        for sample in samples(cracks):
            index = sample["json"]["index"]
            while clean and clean["json"]["index"] < index:
                clean = next(cleans, None)
            if not clean or clean["json"]["index"] != index or sample["json"]["attempt"] > 0:
                continue  # another attempt has another surface
            yield f"{world}_{index:04}", [number, index], sample, clean


def write(pair, arms):
    name, seed, sample, clean = pair
    for arm, (picture, mask) in versions(sample, clean, seed).items():
        write_pair(arms / arm, name, picture, mask)


def main():
    parse = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parse.add_argument("sets", type=Path, help="what make_sets.py made")
    parse.add_argument("arms", type=Path, help="where the arms go, a folder of pictures each")
    parse.add_argument("--workers", type=int, default=os.cpu_count(), help="pictures side by side")
    given = parse.parse_args()
    with Pool(given.workers) as pool:
        waiting = []
        for pair in pairs_of(given.sets):
            waiting.append(pool.apply_async(write, (pair, given.arms)))
            while len(waiting) > 4 * given.workers:  # samples that are held
                waiting.pop(0).get()
        for one in waiting:
            one.get()


if __name__ == "__main__":
    main()
