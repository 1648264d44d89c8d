#!/usr/bin/env python3
"""Measures two builds of craze beside each other, in turn, and prints the table of docs/speed.md
that says what has come of goals.

usage: beside.py BEFORE NOW [--meshes FOLDER] [--only ROW,...] [--repeat N]

BEFORE and NOW are build folders, with the command and, for the row of separation tensors,
craze_benchmarks (CRAZE_BENCHMARKS). Of N runs each (default 3; fewer of what takes long) the median
counts. Rows of two threads are by the clock: nothing else should run. The others are seconds of
processors, one thread.
"""

import argparse
import json
import math
import pathlib
import statistics
import subprocess
import tempfile
import time

from timed_runs import Bench, plate

LARGE = (plate(500), "mud", ["layer.spacing=0.02"])


def run(measure, source, preset, settings=(), threads=1):
    """What a run is measured by: a function of a build."""
    return lambda build: build.bench.run(source, preset, settings, threads)[measure]


def ratio(above, below):
    return lambda build: above(build) / below(build)


def per_triangle(build):
    r = build.bench.run(*LARGE, 2)
    return r["memory"] / r["simulation"]["triangles"]


def tensors(name, noise):
    """µs an evaluation."""

    def measure(build):
        which = f"{name}/noise_percent:{noise}"
        told = subprocess.run([build.benchmarks, f"--benchmark_filter=^{which}$",
                               "--benchmark_format=json"], capture_output=True, check=True)
        found = next(b for b in json.loads(told.stdout)["benchmarks"] if b["name"] == which)
        return 1e6 / found["items_per_second"]

    return measure


def growth(build):
    """The exponent of simulated time against size, at a spacing of ten edges."""
    points = []
    for n in (100, 224, 500, 1415):
        r = build.bench.run(plate(n), "mud", [f"layer.spacing={10 / n}"], 2)
        points.append((math.log(r["simulation"]["triangles"]), math.log(r["simulate"])))
    return statistics.linear_regression(*zip(*points)).slope


def rows(meshes):
    """(name, what, function of a build, what is wanted, most times). Wanted is a factor; or, of
    what is no time, a text."""
    dragon = (str(meshes / "dragon_75k.obj"), "glaze")
    bottle = (str(meshes / "WaterBottle.gltf"), "glaze", ["layer.spacing=0.004"])
    one = ["evolution.max_cracks=1"]
    small = "shape:plate?n=40&jitter=0.3"
    yield ("dragon", "dragon_75k, glaze, simulation, two threads",
           run("simulate", *dragon, threads=2), 2.6 / 1.2, 9)
    yield ("plate", "mud plate n = 99, whole run, two threads",
           run("clock", plate(99), "mud", threads=2), 0.36 / 0.2, 9)
    yield ("threads", "two threads over one, plate n = 500, whole run",
           ratio(run("clock", *LARGE), run("clock", *LARGE, threads=2)), "1.8 now", 3)
    yield ("threads", "two threads over one, plate n = 500, simulation",
           ratio(run("simulate", *LARGE), run("simulate", *LARGE, threads=2)), "1.9 now", 3)
    yield "first", "one crack, plate n = 70", run("processor", plate(70), "mud", one), 2.4, 15
    yield "first", "one crack, cup", run("processor", "shape:cup", "glaze", one), 3.4, 9
    spot = (str(meshes / "spot.obj"), "glaze", one)
    yield "first", "one crack, spot", run("processor", *spot), 2.5, 9
    yield "single", "dragon_75k, glaze, whole run", run("processor", *dragon), 1.3, 9
    yield "single", "mud plate n = 99, whole run", run("processor", plate(99), "mud"), 1.3, 15
    yield "single", "plate n = 500, whole run", run("processor", *LARGE), 1.3, 2
    yield "bottle", "WaterBottle, glaze, 4 mm, whole run", run("processor", *bottle), 53 / 18, 1
    yield ("mature", "mud-mature over mud, plate n = 40",
           ratio(run("processor", small, "mud-mature"), run("processor", small, "mud")), 6.0, 2)
    for noise in (5, 100):
        yield ("tensors", f"separation tensor, noise {noise} %, µs",
               tensors("separation_tensors", noise), 0.5 / 0.15, 9)
        yield ("tensors", f"the same with its eigenpair, noise {noise} %, µs",
               tensors("separation_tensors_with_eigenpair", noise), 0.5 / 0.15, 9)
    yield "memory", "plate n = 500, bytes a triangle", per_triangle, 1004 / 700, 3
    yield "growth", "exponent of simulated time, 20,000 to 4 million", growth, "1.05 now", 1


class Build:
    def __init__(self, folder, scratch):
        self.bench = Bench(folder / "craze", 1, scratch)
        self.benchmarks = next(iter(folder.rglob("craze_benchmarks")), None)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", type=pathlib.Path)
    parser.add_argument("now", type=pathlib.Path)
    parser.add_argument("--meshes", type=pathlib.Path, default=pathlib.Path())
    parser.add_argument("--only", help="rows by their short names: dragon, plate, threads, first, "
                        "single, bottle, mature, tensors, memory, growth")
    parser.add_argument("--repeat", type=int, default=3)
    options = parser.parse_args()
    only = options.only and options.only.split(",")
    started = time.monotonic()
    print("| what | before | now | factor | wanted | times each |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as scratch:
        builds = [Build(folder, scratch) for folder in (options.before, options.now)]
        for name, what, measure, wanted, most in rows(options.meshes):
            if only and name not in only:
                continue
            times = min(options.repeat, most)
            found = [[measure(build) for build in builds] for _ in range(times)]
            before, now = (statistics.median(x) for x in zip(*found))
            factor = statistics.median(a / b for a, b in found)
            asked = wanted if isinstance(wanted, str) else f"{wanted:.2g}"
            cells = [what, f"{before:.3g}", f"{now:.3g}", f"{factor:.2f}", asked, str(times)]
            print(f"| {' | '.join(cells)} |", flush=True)
    print(f"\n{time.monotonic() - started:.0f} s in all")


if __name__ == "__main__":
    main()
