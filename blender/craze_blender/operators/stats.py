"""bpy.ops.craze.stats(): the statistics of the pattern."""

from __future__ import annotations

import json
from typing import Any

import bpy

from ..cracked import is_cracked


class CRAZE_OT_stats(bpy.types.Operator):
    """Writes the report of the run, statistics included, to a text of Blender's"""

    bl_idname = "craze.stats"
    bl_label = "Statistics"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        return is_cracked(context.active_object)

    def execute(self, context: Any) -> set[str]:
        thing = context.active_object
        report = json.loads(thing.craze.report)
        name = f"{thing.name} statistics"
        text = bpy.data.texts.get(name) or bpy.data.texts.new(name)
        text.clear()
        text.write(json.dumps(report, indent=2, ensure_ascii=False) + "\n")
        self.report({"INFO"}, "; ".join(f"{what}: {value}" for what, value in summary(report)))
        return {"FINISHED"}


def summary(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What the panel shows of a report."""
    found = report["cracks"]
    rows = [
        ("Cracks", str(found["events"])),
        ("Pieces", str(found["fragments"])),
        ("Length", f"{found['length']:.4g}"),
    ]
    statistics = report.get("statistics")
    if statistics:
        rows.append(("Spacing", _measured(statistics["spacing"]["root_area"])))
        rows.append(("Junctions", str(statistics["counts"]["junctions"])))
        rows.append(("T-shaped", _measured(statistics["angles"]["t"])))
    return rows


def _measured(found: dict[str, Any]) -> str:
    """A value and its error; both are null where there was too little to measure."""
    if found["value"] is None:
        return "–"
    error = "" if found["error"] is None else f" ± {found['error']:.1g}"
    return f"{found['value']:.3g}{error}"


CLASSES = [CRAZE_OT_stats]
