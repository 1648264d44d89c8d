#!/usr/bin/env python3
"""Measures every claim about the patterns and writes them as a Markdown table, rows that fall short
included.

usage: patterns.py CRAZE OUT.md [--only REGEX] [--meshes FOLDER] [--cache FOLDER] [--jobs N]

Runs and rows are kept in the cache (default OUT.md.runs) for one program file: an interrupted call
goes on where it stopped, and rows not chosen by --only stay as they were last measured. Rows that
need a mesh file are not run without --meshes.
"""

import argparse
import concurrent.futures
import math
import pathlib
import re
import sys

from pattern_runs import (Runner, crossings, deviations, mean_and_error, mean_deviation, slope,
                          value)
from skeleton import skeleton_graph

PLATE = "shape:plate?n=60&jitter=0.3"
SEEDS = (1, 2, 3)
MORE_SEEDS = tuple(range(1, 17))  # where a run takes less than a second
ROWS = []


def row(name, target, seeds):
    """A row: its function gives (what was measured, whether it passes); None: an input is missing."""
    def add(measure):
        ROWS.append((name, target, seeds, measure))
        return measure
    return add


def number(mean, error, unit=""):
    text = f"{mean:.3g}{unit}"
    return text if math.isnan(error) else f"{text} ± {error:.2g}"


# Direction: tension along one axis. Rows: a mesh, and the axes of the tension in the world.

def in_plane(degrees):
    return (math.cos(math.radians(degrees)), math.sin(math.radians(degrees)), 0.0)


def direction(source, axes, **settings):
    def measure(runs):
        parts, good = [], True
        for label, axis in axes:
            x, y, z = axis
            tensor = [x * x, y * y, z * z, x * y, y * z, z * x]
            done = [runs.run(source, "mud", seed, True, stress__uniform=0, stress__tensor=tensor,
                             **settings) for seed in SEEDS[:2]]
            if None in done:
                return None
            pairs = [mean_deviation(deviations(lines, axis)) for _, lines in done]
            mean, error = mean_and_error([m for m, _ in pairs])
            rms, _ = mean_and_error([r for _, r in pairs])
            parts.append(f"{label}: {number(mean, error, '°')}, rms {rms:.2g}°")
            good = good and abs(mean) <= 2 and rms <= 8
        return "; ".join(parts), good
    return measure


ANGLES = [(f"{a}°", in_plane(a)) for a in (0, 15, 23, 30, 45)]
SQUARE = "mean ≤ 2°, rms ≤ 8°"
for mesh, spec in (("regular grid", "shape:plate?n=80"), ("jittered grid",
                                                          "shape:plate?n=80&jitter=0.3")):
    row(f"direction, {mesh}", SQUARE, SEEDS[:2])(direction(spec, ANGLES, mesh__edge="keep"))
AXES = [("x", (1.0, 0, 0)), ("y", (0, 1.0, 0)), ("z", (0, 0, 1.0))]
# A layer does not feel what is finer than its ℓ: on folds as narrow, tension along one axis of the
# world is no tension along one direction of the layer.
for mesh, spacing, remark in (("bunny_51k", 0.02, ""), ("armadillo_100k", 0.015, ""),
                              ("lucy_100k", 0.05, ", whose folds are finer than the spacing")):
    row(f"direction, remeshed {mesh}, spacing {100 * spacing:g} % of the diagonal{remark}", SQUARE,
        SEEDS[:2])(direction(f"{mesh}.obj", AXES, layer__relative_spacing=spacing))


# Resolution: the same recipe on finer meshes.

def resolution(key, label):
    def measure(runs):
        length, means, parts = 0.07, [], []
        for ratio in (4, 8, 16):
            numbers = []
            for seed in RESOLUTION_SEEDS:
                report = runs.run("shape:plate?n=20&jitter=0.3", "mud", seed,
                                  layer__screening_length=length, mesh__edge=length / ratio)
                numbers.append(math.sqrt(1 / report["cracks"]["fragments"]) if key is None
                               else report["cracks"]["length"] if key == "length"
                               else value(report, key))
            mean, error = mean_and_error(numbers)
            means.append(mean)
            parts.append(f"ℓ/h = {ratio}: {number(mean, error)}")
        middle = sum(means) / 3
        spread = max(abs(m / middle - 1) for m in means)
        return f"{'; '.join(parts)}; within {100 * spread:.2g} %", spread <= 0.1
    row(f"resolution, {label}", "within 10 % of their mean", RESOLUTION_SEEDS)(measure)


RESOLUTION_SEEDS = (1, 2, 3, 4, 5)
resolution("length", "crack length per area")
resolution(None, "root of the mean fragment area")
resolution("angles.t", "T fraction")
resolution("edges.tortuosity", "tortuosity")

# Flaws, of every preset for layers.

LAYERS = ("glaze", "mud", "mud-mature", "paint", "concrete-crazing", "crackle-glass")


def judged(numbers, passes, percent):
    mean, error = mean_and_error(numbers)
    shown = number(100 * mean, 100 * error, " %") if percent else number(mean, error)
    return shown, passes(mean)


def preset_value(preset, key, target, passes, percent=False):
    seeds = SEEDS if preset == "mud-mature" else MORE_SEEDS

    def measure(runs):
        numbers = [value(runs.run(PLATE, preset, seed), key) for seed in seeds]
        return judged(numbers, passes, percent)
    row(f"{preset}, {key}", target, seeds)(measure)


def at_most(limit):
    return lambda x: x <= limit


def at_least(limit):
    return lambda x: x >= limit


def between(low, high):
    return lambda x: low <= x <= high


for name in LAYERS:
    preset_value(name, "flaws.spurs", "≤ 1 %", at_most(0.01), True)
    preset_value(name, "flaws.micro_cracks", "≤ 1 %", at_most(0.01), True)
    preset_value(name, "areas.slivers", "≤ 2 %", at_most(0.02), True)

# Spacing asked for.


def spacing(shape, source, rounds):
    def measure(runs):
        parts, good = [], True
        for part in (0.02, 0.05, 0.1, 0.2):
            seeds = SEEDS if part >= 0.05 else SEEDS[:1]
            done = [runs.run(source, "glaze", seed, layer__relative_spacing=part,
                             layer__rounds=rounds) for seed in seeds]
            if None in done:
                return None
            # Few cells lie whole inside an open shape at 20 %: all fragments are counted.
            ratios = [math.sqrt(r["statistics"]["surface_area"] / r["cracks"]["fragments"])
                      / r["recipe"]["layer"]["spacing"] for r in done]
            mean, error = mean_and_error(ratios)
            parts.append(f"{100 * part:.0f} %: {number(mean, error)}")
            good = good and abs(mean - 1) <= 0.15
        return "; ".join(parts), good
    row(f"spacing measured over asked, {shape}, in up to {rounds} more rounds",
        "1 ± 0.15 at 2, 5, 10, 20 % of the diagonal", SEEDS)(measure)


for shape, source in (("plate", "shape:plate?n=60&jitter=0.3"), ("sphere", "shape:sphere"),
                      ("cup", "shape:cup")):
    spacing(shape, source, 4)
# Few pieces on limbs and ears: one crack more or less changes the mean.
for shape, source in (("bunny", "bunny_51k.obj"), ("dragon", "dragon_75k.obj")):
    spacing(shape, source, 8)


@row("spacing ∝ ℓ, plate", "exponent 1 ± 0.1", SEEDS)
def spacing_against_length(runs):
    points = []
    for length in (0.02, 0.03, 0.045, 0.07):
        for seed in SEEDS:
            r = runs.run(PLATE, "mud", seed, layer__screening_length=length)
            points.append((length, value(r, "spacing.root_area")))
    exponent, error, _ = slope(points)
    return number(exponent, error), abs(exponent - 1) <= 0.1


@row("strip: pieces' length ∝ load^(−1/2)", "exponent −0.5 ± 0.05", SEEDS)
def strip(runs):
    points = []
    for load in (8, 16, 32, 64):
        for seed in SEEDS:
            # Thinner than ℓ, so that cracks only run across; 40 ℓ long.
            r = runs.run("shape:strip?n=2&length=40&width=0.06", "mud", seed,
                         stress__uniform=0, stress__tensor=[1, 0, 0, 0, 0, 0], mesh__edge="keep",
                         layer__screening_length=1, evolution__max_load=load,
                         material__scatter=0.02, material__process_zone=0.1,
                         evolution__load_step=0)
            points.append((load, 40 / r["cracks"]["fragments"]))
    exponent, error, _ = slope(points)
    return number(exponent, error), abs(exponent + 0.5) <= 0.05


for name in ("mud", "glaze"):
    preset_value(name, "angles.t", "≥ 0.8", at_least(0.8))
    preset_value(name, "order.leg_younger", "≥ 0.97", at_least(0.97))
    preset_value(name, "angles.leg", "90 ± 5", between(85, 95))
    preset_value(name, "cells.sides", "4 ± 0.3", between(3.7, 4.3))

preset_value("mud-mature", "angles.y", "≥ 0.35", at_least(0.35))
preset_value("mud-mature", "cells.sides", "≥ 5.2", at_least(5.2))


@row("mud-mature, largest angle after 1, 2, 4, 8, 25 cycles", "falls toward 120°, relaxing over a "
     "few cycles", SEEDS[:2])
def maturing(runs):
    means = []
    for cycles in (1, 2, 4, 8, 25):
        means.append(mean_and_error(
            [value(runs.run(PLATE, "mud-mature", seed, evolution__cycles=cycles), "angles.max")
             for seed in SEEDS[:2]]))
    first, last = means[0][0], means[-1][0]
    # After four cycles more than half of the way must lie behind.
    good = first - last > 10 and means[2][0] < 0.5 * (first + last)
    return ", ".join(number(m, e, "°") for m, e in means), good


PAINT = (("angles.t", 0.61, 0.88), ("angles.y", 0, 0.06), ("angles.min", 73, 84),
         ("angles.mid", 108, 115), ("angles.max", 164, 174), ("nodes.end", 0.21, 0.47),
         ("nodes.three", 0.46, 0.72), ("nodes.cross", 0.03, 0.1),
         ("nodes.mean_degree", 3.16, 3.24), ("areas.cv", 0.77, 0.85),
         ("edges.cv", 0.64, 0.86), ("edges.tortuosity", 1.08, 1.09))
for key, low, high in PAINT:
    preset_value("paint", key, f"{low} to {high}", between(low, high))


# The published bands are of skeletons of photographs: the same estimator, on such a skeleton.

def as_skeleton(preset, pixels, key, target, passes, percent=False):
    def measure(runs):
        numbers = []
        for seed in MORE_SEEDS:
            report, lines = runs.run(PLATE, preset, seed, True)
            size = report["recipe"]["layer"]["spacing"] / pixels
            numbers.append(value(runs.stats(skeleton_graph(lines, size), "--simplify", "1"), key))
        return judged(numbers, passes, percent)
    row(f"{preset} as a skeleton, {pixels} pixels a spacing, {key}", target, MORE_SEEDS)(measure)


for pixels in (30, 60):
    as_skeleton("paint", pixels, "flaws.spurs", "≤ 1 %", at_most(0.01), True)
    for key, low, high in PAINT:
        as_skeleton("paint", pixels, key, f"{low} to {high}", between(low, high))


@row("glass-impact, rays against amplitude", "N ∝ amplitude^½", SEEDS)
def impact(runs):
    points, parts = [], []
    for amplitude in (4, 8, 16, 32):
        counts = []
        for seed in SEEDS:
            _, lines = runs.run("shape:disc?n=60", "glass-impact", seed, True,
                                evolution__max_load=amplitude)
            counts.append(crossings(lines, (0, 0, 0), IMPACT_RADIUS))
            points.append((amplitude, counts[-1]))
        parts.append(f"{amplitude}: {number(*mean_and_error(counts))}")
    exponent, error, rms = slope(points)
    return (f"exponent {number(exponent, error)}, residual {100 * rms:.2g} % ({'; '.join(parts)})",
            abs(exponent - 0.5) <= 0.1 and rms < 0.15)


IMPACT_RADIUS = 0.1  # half of the impact's, where the amplitude holds in full


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("craze")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--meshes", type=pathlib.Path)
    parser.add_argument("--cache")
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    runs = Runner(args.craze, args.cache or f"{args.out}.runs", args.meshes,
                  1 if args.jobs > 1 else 0)
    chosen = [r for r in ROWS if re.search(args.only, r[0])]

    def measure(entry):
        name, _, _, function = entry
        found = function(runs)
        if found is None:
            return
        text, good = found
        runs.keep_row(name, {"text": text, "verdict": "pass" if good else "falls short"})
        print(f"{name}: {text} ({'pass' if good else 'falls short'})", file=sys.stderr, flush=True)

    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        list(pool.map(measure, chosen))
    table = []
    for name, target, seeds, _ in ROWS:
        kept = runs.row(name) or {"text": "", "verdict": "not run"}
        few = ", ".join(map(str, seeds)) if len(seeds) < 4 else f"{seeds[0]} to {seeds[-1]}"
        table.append(f"| {name} | {kept['text']} | {target} | {few} | {kept['verdict']} |")
    header = "| what | measured ± standard error | target | seeds | |\n|---|---|---|---|---|\n"
    args.out.write_text(header + "\n".join(table) + "\n")


main()
