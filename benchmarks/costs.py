#!/usr/bin/env python3
"""Whether craze still costs what was written down: counts, not seconds, the same on a busy machine.

usage: costs.py CRAZE [--write] [--most RATIO] [--only NAME,...]

Cachegrind counts the instructions of small runs on one thread and the misses of caches whose sizes
are fixed here; a run's cost is KCachegrind's estimate of cycles, instructions + 10 misses of the
first level + 100 of the last. Fails where a cost is more than RATIO (1.15) times that of costs.json;
--write puts down what was counted. Peaks of memory are of whole runs, without Cachegrind. The counts
are those of GCC 12 with AVX2: other compilers and machines differ. Exits with 77 where valgrind is
missing.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

WRITTEN = pathlib.Path(__file__).with_name("costs.json")
CACHES = ["--I1=32768,8,64", "--D1=32768,8,64", "--LL=2097152,16,64"]
MISSES = {"I1  misses": 10, "D1  misses": 10, "LL misses": 100}

PLATE = "shape:plate?n=24&jitter=0.3"
CASES = {
    "mud": [PLATE, "--preset", "mud", "--set", "layer.relative_spacing=0.15"],
    "first crack": [PLATE, "--preset", "mud", "--set", "layer.relative_spacing=0.15",
                    "--max-cracks", "1"],
    "remeshed": ["shape:cup?n=24", "--preset", "glaze", "--set", "layer.relative_spacing=0.3"],
    "cycles": ["shape:plate?n=12&jitter=0.3", "--preset", "mud-mature", "--set",
               "layer.relative_spacing=0.4", "--set", "evolution.cycles=4"],
    "opened": [PLATE, "--preset", "mud", "--set", "layer.relative_spacing=0.15",
               "--set", "post.gap=0.1", "--set", "post.wall=0.02"],
    "solid": ["shape:sphere?n=20", "--preset", "mud", "--set", "layer.relative_spacing=0.2",
              "--set", "post.thickness=0.1"],
    "euler": ["shape:plate?n=12&jitter=0.3", "--preset", "mud", "--set", "engine=euler",
              "--set", "evolution.time_step=0.2", "--set", "evolution.shrinkage=0.01",
              "--set", "layer.relative_spacing=0.3", "--max-cracks", "20"],
}

# Runs whose peak of memory is measured: KiB of the whole process.
PEAKS = {
    "memory PLY": (["shape:cup", "--preset", "glaze"], ".ply"),
    "memory GLB": (["shape:cup", "--preset", "glaze"], ".glb"),
    "memory large": (["shape:plate?n=200", "--preset", "mud"], ".ply"),
}


def peak(craze, arguments, extension, folder):
    command = [craze, "crack", *arguments, "--threads", "1", "--quiet", "--no-warnings",
               "-o", str(folder / f"cracked{extension}")]
    run = subprocess.Popen(command, env={"PATH": "/usr/bin:/bin"})
    _, status, usage = os.wait4(run.pid, 0)
    run.returncode = os.waitstatus_to_exitcode(status)
    if run.returncode != 0:
        sys.exit(f"failed: {' '.join(command)}")
    return usage.ru_maxrss


def cost(craze, arguments, folder):
    command = ["valgrind", "--tool=cachegrind", "--cache-sim=yes", *CACHES,
               "--cachegrind-out-file=/dev/null", craze, "crack", *arguments, "--threads", "1",
               "--quiet", "--no-warnings", "--set", "post.relative_roughness=0",
               "-o", str(folder / "cracked.ply")]
    run = subprocess.run(command, capture_output=True, text=True, env={"PATH": "/usr/bin:/bin"})
    if run.returncode != 0:
        sys.exit(f"failed: {' '.join(command)}\n{run.stderr}")

    def count(name):
        return int(re.search(rf"{name}:\s+([\d,]+)", run.stderr).group(1).replace(",", ""))

    return count("I   refs") + sum(weight * count(name) for name, weight in MISSES.items())


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("craze")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--most", type=float, default=1.15)
    parser.add_argument("--only", default=",".join([*CASES, *PEAKS]))
    options = parser.parse_args()
    if not shutil.which("valgrind"):
        print("no valgrind")
        sys.exit(77)
    written = json.loads(WRITTEN.read_text())
    too_dear = []
    with tempfile.TemporaryDirectory() as folder:
        for name in options.only.split(","):
            if name in PEAKS:
                now, shown = peak(options.craze, *PEAKS[name], pathlib.Path(folder)), "KiB"
            else:
                now, shown = cost(options.craze, CASES[name], pathlib.Path(folder)), "million"
            if options.write:
                written[name] = now
            ratio = now / written[name]
            print(f"{name:13} {now / (1 if shown == 'KiB' else 1e6):8.0f} {shown}, {ratio:.3f} of what was written down",
                  flush=True)
            if ratio > options.most:
                too_dear.append(name)
    if options.write:
        WRITTEN.write_text(json.dumps(written, indent=1) + "\n")
    elif too_dear:
        sys.exit(f"more than {options.most} times as dear: {', '.join(too_dear)}")


main()
