"""Runs of the command that are measured."""

import json
import os
import pathlib
import subprocess
import sys
import time

# Rough lines came later than most of what is compared, and cost after the simulation.
SMOOTH = "post.relative_roughness=0"


class Bench:
    """Runs of one binary of craze, whichever commit it is of."""

    def __init__(self, craze, repeat, folder):
        self.craze, self.repeat, self.folder = str(craze), repeat, pathlib.Path(folder)
        known = subprocess.run([self.craze, "parameters"], capture_output=True, text=True).stdout
        self.always = [SMOOTH] if "relative_roughness" in known else []

    def run(self, source, preset, settings=(), threads=0):
        """One run that writes a mesh; its report, with peak memory in bytes, the seconds simulated,
        and of the whole command seconds by the clock and of processors."""
        report = self.folder / "report.json"
        command = [self.craze, "crack", source, "--preset", preset, "--quiet",
                   "--report", str(report), "-o", str(self.folder / "cracked.ply")]
        if threads:
            command += ["--threads", str(threads)]
        for s in [*self.always, *settings]:
            command += ["--set", s]
        start = time.monotonic()
        process = subprocess.Popen(command)
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            sys.exit(f"failed: {' '.join(command)}")
        r = json.loads(report.read_text())
        r["clock"] = time.monotonic() - start
        r["processor"] = usage.ru_utime + usage.ru_stime
        r["memory"] = usage.ru_maxrss * 1024
        r["simulate"] = sum(r["time"][k] for k in ("relax", "separation", "crack"))
        return r

    def medians(self, cases):
        """Runs the cases in turn, `repeat` times; the median report of each by simulated time."""
        runs = [[] for _ in cases]
        for _ in range(self.repeat):
            for i, case in enumerate(cases):
                runs[i].append(self.run(*case))
        return [sorted(r, key=lambda x: x["simulate"])[len(r) // 2] for r in runs]


def plate(n):
    return f"shape:plate?n={n}&jitter=0.3"
