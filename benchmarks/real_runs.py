#!/usr/bin/env python3
"""Cracks a list of meshes and prints a Markdown table of counts and times.

usage: real_runs.py CRAZE MESH_FOLDER OUT_FOLDER

Meshes that the folder lacks are left out. Pictures and reports go to OUT_FOLDER.
"""

import json
import pathlib
import subprocess
import sys

RUNS = [
    ("mud plate", "shape:plate?n=99&jitter=0.3", "mud"),
    ("cup (built in)", "shape:cup", "glaze"),
    ("teacup", "teacup_40k.obj", "glaze"),
    ("bunny", "bunny_51k.obj", "glaze"),
    ("teapot, open, three parts", "teapot_60k.obj", "glaze"),
    ("dragon", "dragon_75k.obj", "glaze"),
    ("scanned bunny with holes", "stanford-bunny_raw.obj", "glaze"),
    ("dragon, not manifold", "dragon_vrip_res3_raw.ply", "glaze"),
    ("spot, with UVs", "spot.obj", "glaze"),
]


def main():
    craze, meshes, out = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    out.mkdir(parents=True, exist_ok=True)
    print("| run | input triangles | simulated | output | events | pieces | crack length "
          "| prepare s | simulate s | stop |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for name, source, preset in RUNS:
        path = source if source.startswith("shape:") else str(meshes / source)
        if not source.startswith("shape:") and not (meshes / source).exists():
            continue
        stem = source.split("?")[0].replace("shape:", "shape_").rsplit(".", 1)[0]
        report = out / (stem + ".json")
        subprocess.run(
            [craze, "crack", path, "--preset", preset, "-o", str(out / (stem + ".glb")),
             "--picture", str(out / (stem + ".png")), "--report", str(report), "--quiet"],
            check=True)
        r = json.loads(report.read_text())
        simulate = r["time"]["relax"] + r["time"]["separation"] + r["time"]["crack"]
        print(f"| {name} | {r['input']['triangles']:,} | {r['simulation']['triangles']:,} "
              f"| {r['output']['triangles']:,} | {r['cracks']['events']:,} "
              f"| {r['cracks']['fragments']:,} | {r['cracks']['length']:.4g} "
              f"| {r['time']['prepare']:.1f} | {simulate:.1f} | {r['stop_reason']} |",
              flush=True)


main()
