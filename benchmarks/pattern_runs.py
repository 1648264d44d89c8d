"""Runs of craze for patterns.py: kept on disk by what was asked for, so that nothing runs twice."""

import hashlib
import json
import math
import os
import pathlib
import subprocess
import threading


class Runner:
    """Runs the command with a report, and lines where asked; None where the input is not there."""

    def __init__(self, craze, cache, meshes, threads):
        self.craze, self.meshes, self.threads = craze, meshes, threads
        self.cache = pathlib.Path(cache)
        self.cache.mkdir(parents=True, exist_ok=True)
        self.program = hashlib.sha256(pathlib.Path(craze).read_bytes()).hexdigest()

    def _row_file(self, name):
        key = hashlib.sha256((self.program + name).encode()).hexdigest()[:24]
        return self.cache / f"{key}.row.json"

    def keep_row(self, name, measured):
        """Remembers what this program measured for a row of the table."""
        self._row_file(name).write_text(json.dumps({"name": name, **measured}))

    def row(self, name):
        """What was remembered of a row, or None."""
        file = self._row_file(name)
        return json.loads(file.read_text()) if file.exists() else None

    def path(self, source):
        if source.startswith("shape:"):
            return source
        mesh = self.meshes / source if self.meshes else None
        return str(mesh) if mesh and mesh.exists() else None

    def run(self, source, preset, seed=1, lines=False, **settings):
        """settings: section__key=value. The report; with lines, a pair of report and lines."""
        path = self.path(source)
        if path is None:
            return None
        # The lines as they were simulated, without the roughness put on them.
        asked = [path, "--preset", preset, "--seed", str(seed), "--set", "post.relative_roughness=0"]
        for key, value in sorted(settings.items()):
            asked += ["--set", f"{key.replace('__', '.')}={value}"]
        name = hashlib.sha256("\n".join([self.program, *asked]).encode()).hexdigest()[:24]
        report, drawn = self.cache / f"{name}.json", self.cache / f"{name}.lines.json"
        if not report.exists() or (lines and not drawn.exists()):
            mine = self.cache / f"{name}.{os.getpid()}-{threading.get_ident()}.json"
            command = [self.craze, "crack", *asked, "--threads", str(self.threads), "--quiet",
                       "--report", str(mine)]
            if lines:
                command += ["--lines", str(mine.with_suffix(".lines.json"))]
            subprocess.run(command, check=True)
            if lines:
                os.replace(mine.with_suffix(".lines.json"), drawn)
            os.replace(mine, report)
        loaded = json.loads(report.read_text())
        return (loaded, json.loads(drawn.read_text())) if lines else loaded

    def stats(self, lines, *options):
        """The report's statistics of lines that no run has made."""
        text = json.dumps(lines)
        name = hashlib.sha256("\n".join([self.program, text, *options]).encode()).hexdigest()[:24]
        kept = self.cache / f"{name}.stats.json"
        if not kept.exists():
            drawn = self.cache / f"{name}.{os.getpid()}-{threading.get_ident()}.json"
            drawn.write_text(text)
            command = [self.craze, "stats", str(drawn), "--json", *options]
            found = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            drawn.unlink()
            kept.write_text(found)
        return {"statistics": json.loads(kept.read_text())}


def value(report, key):
    """A value of the report's statistics, NaN where it was not measured."""
    section, name = key.split(".")
    if not report["statistics"]:
        return math.nan
    number = report["statistics"][section][name]["value"]
    return math.nan if number is None else number


def mean_and_error(numbers):
    """Mean and its standard error; of a single number the error is NaN."""
    numbers = [x for x in numbers if not math.isnan(x)]
    if not numbers:
        return math.nan, math.nan
    mean = sum(numbers) / len(numbers)
    if len(numbers) < 2:
        return mean, math.nan
    variance = sum((x - mean) ** 2 for x in numbers) / (len(numbers) - 1)
    return mean, math.sqrt(variance / len(numbers))


def slope(points):
    """Exponent of a power law through (x, y) with its standard error, and the rms of log residuals."""
    logs = [(math.log(x), math.log(y)) for x, y in points if x > 0 and y > 0]
    n = len(logs)
    if n < 3:
        return math.nan, math.nan, math.nan
    mx, my = sum(x for x, _ in logs) / n, sum(y for _, y in logs) / n
    sxx = sum((x - mx) ** 2 for x, _ in logs)
    exponent = sum((x - mx) * (y - my) for x, y in logs) / sxx
    residual = sum((y - my - exponent * (x - mx)) ** 2 for x, y in logs)
    return exponent, math.sqrt(residual / (n - 2) / sxx), math.sqrt(residual / n)


def deviations(lines, axis):
    """(length, degrees in ]-90, 90]) of each piece of crack from square to the axis, in the surface;
    left out where the axis stands steeply on the surface, which bears little of the tension there."""
    points, normals = lines["points"], lines["point_attributes"]["normal"]
    found = []
    for a, b in lines["edges"]:
        n = unit([x + y for x, y in zip(normals[a], normals[b])])
        d = [q - p for p, q in zip(points[a], points[b])]
        pull = [x - dot(axis, n) * m for x, m in zip(axis, n)]
        if dot(pull, pull) < 0.5 or dot(d, d) == 0:
            continue
        square = cross(n, unit(pull))
        d = [x - dot(d, n) * m for x, m in zip(d, n)]
        angle = math.degrees(math.atan2(dot(cross(square, d), n), dot(square, d)))
        found.append((math.sqrt(dot(d, d)), angle - 180 * round(angle / 180)))
    return found


def mean_deviation(found):
    """Mean over directions, of period 180 degrees, and root mean square; weighted by length."""
    total = sum(length for length, _ in found)
    if total == 0:
        return math.nan, math.nan
    x = sum(length * math.cos(math.radians(2 * d)) for length, d in found)
    y = sum(length * math.sin(math.radians(2 * d)) for length, d in found)
    rms = math.sqrt(sum(length * d * d for length, d in found) / total)
    return math.degrees(math.atan2(y, x)) / 2, rms


def crossings(lines, centre, radius):
    """Pieces of crack that cross the sphere about a point."""
    def far(i):
        return math.dist(lines["points"][i], centre) >= radius
    return sum(far(a) != far(b) for a, b in lines["edges"])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(dot(a, a)) or 1
    return [x / length for x in a]
