#!/usr/bin/env python3
"""Predicts how much faster craze would be on many cores: the table of docs/speed.md.

usage: work_and_span.py [CRAZE] [--meshes FOLDER] [--only NAME,...] [--loops]

CRAZE is a command built with CRAZE_WORK_AND_SPAN, which runs every loop one task after the other and
times each (processor time, so that a busy machine does not matter); without it `cmake --preset span`
is built here. On N cores a loop takes as long as its tasks do, each given to the core that is free
first; what lies between loops takes as long as on one. Opening a loop costs nothing, and caches and
memory are as fast for many as for one: so this is what the program allows, not what a machine gives.
--loops adds where the time is: in each loop, and in one thread before it.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

CORES = (1, 2, 4, 8, 16, 64)  # WorkAndSpan::cores
HERE = pathlib.Path(__file__).resolve().parent.parent

# Loops of the simulation itself, by what they begin with.
SIMULATION = ("TangentStiffness", "Equilibrium", "FailureWatch")


def build():
    folder = HERE / "build" / "span"
    for command in (["cmake", "--preset", "span"],
                    ["cmake", "--build", str(folder), "--target", "craze_app"]):
        subprocess.run(command, cwd=HERE, check=True, stdout=subprocess.DEVNULL)
    return str(folder / "craze")


def cases(meshes):
    yield "mud plate, n = 99", "shape:plate?n=99&jitter=0.3", "mud", []
    yield "mud plate, n = 500", "shape:plate?n=500&jitter=0.3", "mud", ["layer.spacing=0.02"]
    yield "cup", "shape:cup", "glaze", []
    yield "cup, gap and wall", "shape:cup", "glaze", ["post.gap=0.1", "post.wall=0.1"]
    for name in ("bunny_51k", "dragon_75k"):
        path = meshes and meshes / f"{name}.obj"
        if path and path.exists():
            yield name, str(path), "glaze", []


class Run:
    """Rows of (name, loops, tasks, seconds before, seconds on each number of cores); seconds after
    the last loop."""

    def __init__(self, craze, source, preset, settings, folder):
        # With one thread there is nothing that runs loops.
        command = [craze, "crack", source, "--preset", preset, "--quiet", "--no-warnings",
                   "--set", "post.relative_roughness=0",
                   "--threads", str(max(CORES)), "-o", os.path.join(folder, "cracked.ply")]
        for s in settings:
            command += ["--set", s]
        with tempfile.TemporaryFile("w+") as told:
            process = subprocess.Popen(command, stderr=told, stdout=subprocess.DEVNULL)
            _, status, usage = os.wait4(process.pid, 0)
            told.seek(0)
            lines = [line.rstrip("\n").split("\t") for line in told]
        if status != 0:
            sys.exit(f"failed: {' '.join(command)}\n{lines}")
        self.rows = [(r[1], int(r[2]), int(r[3]), float(r[4]), [float(x) for x in r[5:]])
                     for r in lines if r[0] == "loop"]
        if not self.rows:
            sys.exit(f"{craze} was not built with CRAZE_WORK_AND_SPAN")
        self.after = sum(float(r[1]) for r in lines if r[0] == "after")
        self.after += max(0, usage.ru_utime + usage.ru_stime - self.seconds(0))  # the process's end

    def seconds(self, i, chosen=None):
        rows = [r for r in self.rows if chosen is None or chosen(r[0])]
        return sum(r[3] + r[4][i] for r in rows) + (self.after if chosen is None else 0)


def is_simulation(name):
    return name.startswith(SIMULATION)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("craze", nargs="?")
    parser.add_argument("--meshes", type=pathlib.Path)
    parser.add_argument("--only")
    parser.add_argument("--loops", action="store_true")
    options = parser.parse_args()
    craze = options.craze or build()
    wanted = options.only.split(",") if options.only else None
    heads = " | ".join(f"{n} cores" for n in CORES[1:])
    print(f"| run | part | one core s | in loops | {heads} |\n|---|---|---|---|{'---|' * len(CORES[1:])}")
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for name, source, preset, settings in cases(options.meshes):
            if wanted and name not in wanted:
                continue
            run = Run(craze, source, preset, settings, folder)
            found.append((name, run))
            for part, chosen in (("whole", None), ("simulation", is_simulation)):
                one = run.seconds(0, chosen)
                inside = sum(r[4][0] for r in run.rows if chosen is None or chosen(r[0]))
                times = " | ".join(f"{one / run.seconds(i, chosen):.2f}"
                                   for i in range(1, len(CORES)))
                print(f"| {name} | {part} | {one:.2f} | {100 * inside / one:.0f} % | {times} |",
                      flush=True)
    if not options.loops:
        return
    for name, run in found:
        one = run.seconds(0)
        print(f"\n{name}:\n\n| loop | times | tasks each | in one thread before | in the loop "
              "| there on 16 cores |\n|---|---|---|---|---|---|")
        for row in sorted(run.rows, key=lambda r: -r[3] - r[4][0]):
            if row[3] + row[4][0] < 0.005 * one:
                continue
            print(f"| {row[0]} | {row[1]:,} | {row[2] / row[1]:.1f} | {100 * row[3] / one:.1f} % | "
                  f"{100 * row[4][0] / one:.1f} % | {100 * row[4][CORES.index(16)] / one:.1f} % |")
        print(f"| after the last | | | {100 * run.after / one:.1f} % | | |")


main()
