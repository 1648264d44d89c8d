"""Training sets from the plans: each sample twice, with its cracks and, the same surface, lamp, marks
and camera, without them. baselines.py draws other lines on the latter.

    python3 make_sets.py sets --craze ../../build/release/craze --samples 60
"""

import argparse
import json
import subprocess
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

PLANS = Path(__file__).resolve().parents[2] / "recipes" / "datasets"
WORLDS = ("pavement", "wall", "ceramic", "painting", "dry_soil")
SIZE = 256
SHARD = 10


def toml(value):
    """A value as TOML writes it in a line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k)} = {toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def scaled(value, factor):
    """A distribution of a positive number, times a factor."""
    if isinstance(value, dict):
        return {kind: [factor * x for x in ends] for kind, ends in value.items()}
    return factor * value


def benchmark_plan(plan, clean):
    """The plan for pictures of 256 pixels that are the middle of those of 512. The camera's faults are
    left to the training, which adds them to all sets alike."""
    made = {key: value for key, value in plan.items() if isinstance(value, dict)}
    made["camera"] = dict(plan["camera"], zoom=scaled(plan["camera"]["zoom"], 2))
    made["image"] = {"exposure": plan["image"]["exposure"], "blur": 0, "noise": 0, "quality": 100}
    top = dict(seed=plan["seed"], width=SIZE, height=SIZE, shard_samples=SHARD)
    top["clean"] = 1 if clean else plan["clean"]
    lines = [f"{key} = {toml(value)}" for key, value in top.items()]
    lines += [f"{key} = {toml(value)}" for key, value in made.items()]
    return "\n".join(lines) + "\n"


def main():
    parse = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parse.add_argument("folder", type=Path)
    parse.add_argument("--craze", required=True, help="the command")
    parse.add_argument("--samples", type=int, default=60, help="of each plan")
    parse.add_argument("--threads", type=int, default=0, help="of a command; 0: all")
    parse.add_argument("--jobs", type=int, default=1, help="commands side by side")
    given = parse.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    plans = []
    for world in WORLDS:
        plan = tomllib.loads((PLANS / f"{world}.toml").read_text())
        for kind in ("cracks", "clean"):
            plans.append(given.folder / f"{world}_{kind}.toml")
            plans[-1].write_text(benchmark_plan(plan, kind == "clean"))
    rounds = -(-given.samples // SHARD)

    def make(one):
        """A shard of a plan."""
        part, file = one
        subprocess.run(
            [given.craze, "dataset", file, "-o", file.with_suffix("")]
            + ["--samples", str(given.samples), "--shard", f"{part}/{rounds}"]
            + ["--threads", str(given.threads), "--quiet"],
            check=True,
        )

    # by rounds, so that a run that is stopped has something of each
    with ThreadPoolExecutor(given.jobs) as pool:
        list(pool.map(make, [(part, file) for part in range(rounds) for file in plans]))


if __name__ == "__main__":
    main()
