"""The table of docs/transfer.md from what run.py wrote: means over seeds with their 95 % intervals.

    python3 table.py results.json
    python3 table.py results.json --into ../../docs/transfer.md
"""

import argparse
import json
import math
from pathlib import Path

MEASURES = {
    "iou": "IoU",
    "f1": "F1",
    "boundary_f1": "boundary F1",
    "cl_iou": "clIoU",
    "cl_dice": "clDice",
    "false_on_clean": "false on clean, %",
    "width_error": "width error, px",
}
MARKS = ("<!-- results: table.py -->", "<!-- end of results -->")
LOWER_IS_BETTER = {"false_on_clean", "width_error"}
# Student's t at 97.5 % for 1, 2, … degrees of freedom; beyond, the normal law's is too small by < 5 %
STUDENT = [12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26, 2.23, 2.20, 2.18, 2.16, 2.14, 2.13,
           2.12, 2.11, 2.10, 2.09, 2.09]  # fmt: skip


def interval(values):
    """Mean and half of the 95 % interval of the mean; nan for fewer than two values."""
    n = len(values)
    mean = sum(values) / n
    if n < 2:
        return mean, math.nan
    spread = math.sqrt(sum((v - mean) ** 2 for v in values) / (n - 1))
    return mean, (STUDENT[n - 2] if n - 2 < len(STUDENT) else 2.05) * spread / math.sqrt(n)


def by_arm(results):
    """{arm: {measure: (mean, half)}}, in the order of their first run, and {arm: (pictures, seeds)}."""
    table, counts = {}, {}
    for run in results["runs"]:
        table.setdefault(run["arm"], []).append(run["measures"])
        counts[run["arm"]] = (run["pictures"], len(table[run["arm"]]))
    means = {
        arm: {m: interval([r[m] for r in runs]) for m in MEASURES} for arm, runs in table.items()
    }
    return means, counts


def cell(measure, mean, half):
    if math.isnan(mean):
        return "–"
    percent, digits = measure == "false_on_clean", 3
    if percent or measure == "width_error":
        digits = 2
    numbers = [mean] if math.isnan(half) else [mean, half]  # a single seed has no interval
    return " ± ".join(f"{(100 if percent else 1) * x:.{digits}f}" for x in numbers)


def verdict(measure, ours, other):
    """Whether two intervals lie apart, and which is better."""
    (a, p), (b, q) = ours, other
    if math.isnan(p + q) or abs(a - b) <= p + q:
        return "overlap"
    return "better" if (a < b) == (measure in LOWER_IS_BETTER) else "worse"


def text(results, ours="craze", others=("craze_painted", "voronoi", "walks")):
    means, counts = by_arm(results)
    names = " | ".join(MEASURES.values())
    lines = [f"| trained on | pictures | seeds | {names} |"]
    lines.append("|" + "---|" * (len(MEASURES) + 3))
    for arm, row in means.items():
        pictures, seeds = counts[arm]
        cells = [cell(m, *row[m]) for m in MEASURES]
        count = " + ".join(map(str, pictures))
        lines.append(f"| {arm} | {count} | {seeds} | {' | '.join(cells)} |")
    lines.append("")
    lines.append(f"`{ours}` beside the others (overlap: the seeds do not tell them apart):")
    lines.append("")
    lines.append(f"| beside | {names} |")
    lines.append("|" + "---|" * (len(MEASURES) + 1))
    for other in others:
        if ours in means and other in means:
            said = [verdict(m, means[ours][m], means[other][m]) for m in MEASURES]
            lines.append(f"| {other} | {' | '.join(said)} |")
    setting = results["setting"]
    lines.append("")
    lines.append(
        f"{setting['steps']} steps of {setting['batch']} squares of {setting['size']}², "
        f"PyTorch {setting['torch']} on {setting['device']}."
    )
    return "\n".join(lines)


def placed(page, told):
    """The page with the text between its marks, in place of what was there."""
    head, rest = page.split(MARKS[0])
    _, tail = rest.split(MARKS[1])
    return head + MARKS[0] + "\n" + told + "\n" + MARKS[1] + tail


def main():
    parse = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parse.add_argument("results", type=Path)
    parse.add_argument("--into", type=Path, help="a page that has a marked place for it")
    given = parse.parse_args()
    told = text(json.loads(given.results.read_text()))
    if given.into:
        given.into.write_text(placed(given.into.read_text(), told))
    else:
        print(told)


if __name__ == "__main__":
    main()
