"""Stress painted on a mesh: only the upper half of a sphere pulls, so only there it cracks.

A file of your own does as well: craze.read("scan.ply").
"""

import numpy as np

import craze

mesh = craze.shape("sphere?n=24")
height = mesh.vertices[:, 2]
mesh.vertex_attributes["pull"] = np.clip(4 * height / height.max(), 0, 1)

recipe = craze.presets()["glaze"]
recipe["stress"]["attribute"] = "pull"
result = craze.crack(mesh, recipe, seed=3)
above = result.lines.points[:, 2] > 0
print(f"{np.mean(above):.0%} of {len(above)} points of cracks are in the upper half")
result.write("painted.ply")
