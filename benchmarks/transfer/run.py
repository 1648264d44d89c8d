"""Trains every arm with every seed and judges it on the test pictures; writes after each training,
and goes on where an earlier run with the same settings was stopped.

    python3 run.py --data DATA --out results.json

DATA has a folder per set of pictures: craze, craze_painted, voronoi, walks, and real/ with train and
test, or a set of one's own in their place, --real FOLDER (layouts: data.py).
"""

import argparse
import json
import multiprocessing
import time
from pathlib import Path

import torch

from data import load
from metrics import Tally
from unet import masks_of, train

SYNTHETIC = ("craze", "craze_painted", "voronoi", "walks")
PARTS = (10, 40)  # of the real pictures, how many are trained on


def arms_of(synthetic, real, parts):
    """Names of arms and what each is trained on: (set, how many pictures of it; None: all)."""
    arms = {name: [(name, None)] for name in synthetic}
    for part in parts:
        arms[f"real {part}"] = [(real, part)]
        arms[f"craze + real {part}"] = [("craze", None), (real, part)]
    return arms


class Store:
    """Sets of pictures on a device, each read once."""

    def __init__(self, given):
        self.given, self.held = given, {}

    def get(self, name, part, most=None):
        key = (name, part, most)
        if key not in self.held:
            own = name == "real" and self.given.real is not None
            folder = self.folder(name, part)
            pictures, masks = load(folder, part, self.given.size, most, split=own)
            self.held[key] = (
                torch.from_numpy(pictures).permute(0, 3, 1, 2).contiguous().to(self.given.device),
                torch.from_numpy(masks)[:, None].to(self.given.device),
            )
        return self.held[key]

    def folder(self, name, part):
        if name != "real":
            return Path(self.given.data) / name
        if self.given.real:
            return Path(self.given.real)
        return Path(self.given.data) / "real" / part


store = None


def prepare(given):
    global store
    torch.set_num_threads(given.threads)
    store = Store(given)


def one(task):
    """Trains an arm with a seed; its measures."""
    arm, sets, seed = task
    given, start = store.given, time.time()
    sources = [store.get(name, "train", most) for name, most in sets]
    net = train(sources, seed, given.steps, given.batch, given.device, given.channels)
    pictures, truth = store.get("real", "test", given.test)
    found, truth = masks_of(net, pictures), truth[:, 0].cpu().numpy()
    trained, tally = time.time(), Tally()
    for f, t in zip(found, truth):
        tally.add(f, t)
    return {
        "arm": arm,
        "seed": seed,
        "pictures": [len(x) for x, _ in sources],
        "measures": tally.measures(),
        "sums": {k: float(v) for k, v in tally.sums.items()},
        "seconds": [round(trained - start, 2), round(time.time() - trained, 2)],
    }


def setting_of(given):
    """What the measures depend on."""
    kept = ("steps", "batch", "channels", "size", "test", "device")
    setting = {name: getattr(given, name) for name in kept}
    setting["torch"] = torch.__version__
    if given.device == "cuda":
        setting["device"] = torch.cuda.get_device_name()
    return setting


def done(path, setting):
    """Runs that a file has from before; ends where they were made with other settings."""
    if not path.exists():
        return []
    before = json.loads(path.read_text())
    if before["setting"] != setting:
        raise SystemExit(f"{path} was made with other settings: {before['setting']}")
    return before["runs"]


def arguments():
    parse = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parse.add_argument("--data", required=True)
    parse.add_argument("--real", help="a real set of your own, in place of DATA/real")
    parse.add_argument("--out", required=True, type=Path, help="results, JSON")
    parse.add_argument("--seeds", type=int, default=6)
    parse.add_argument("--steps", type=int, default=800)
    parse.add_argument("--batch", type=int, default=16)
    parse.add_argument("--channels", type=int, default=24)
    parse.add_argument("--size", type=int, default=256, help="of the squares, pixels")
    parse.add_argument("--parts", type=int, nargs="*", default=PARTS, help="real pictures in arms")
    parse.add_argument("--test", type=int, help="only so many test pictures")
    parse.add_argument("--arms", nargs="*", help="only these")
    parse.add_argument("--device", default="auto", help="auto, cpu, cuda")
    parse.add_argument("--workers", type=int, default=1, help="trainings side by side")
    parse.add_argument("--threads", type=int, default=2, help="of each")
    parse.add_argument("--limit", type=float, default=1e9, help="seconds after which none starts")
    given = parse.parse_args()
    if given.device == "auto":
        given.device = "cuda" if torch.cuda.is_available() else "cpu"
    return given


def main():
    given, start = arguments(), time.time()
    arms = arms_of(SYNTHETIC, "real", given.parts)
    chosen = {name: sets for name, sets in arms.items() if not given.arms or name in given.arms}
    seeds = range(1, given.seeds + 1)
    tasks = [(arm, sets, seed) for seed in seeds for arm, sets in chosen.items()]
    setting = setting_of(given)
    runs = done(given.out, setting)
    known = {(run["arm"], run["seed"]) for run in runs}
    tasks = [task for task in tasks if (task[0], task[2]) not in known]
    context = multiprocessing.get_context("spawn")
    with context.Pool(given.workers, prepare, (given,)) as pool:
        for run in pool.imap_unordered(one, tasks):
            runs.append(run)
            text = json.dumps({"setting": setting, "runs": runs}, indent=1)
            part = given.out.with_suffix(".part")
            part.write_text(text)
            part.replace(given.out)
            f1 = run["measures"]["f1"]
            took = time.time() - start
            print(f"{took:6.1f} s  {run['arm']}  seed {run['seed']}  F1 {f1:.3f}", flush=True)
            if took > given.limit:
                print(f"stopped at the limit, {len(runs)} trainings done", flush=True)
                pool.terminate()
                break


if __name__ == "__main__":
    main()
