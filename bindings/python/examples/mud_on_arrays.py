"""Mud on arrays: a plate of 2 × 40 × 40 triangles, cracked and written with its cracks open."""

import numpy as np

import craze

n = 40
x, y = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1))
vertices = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
i = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
a, b, c, d = (corner.reshape(-1) for corner in (i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]))
faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])

result = craze.crack((vertices, faces), "mud", seed=7)
print(result)
result.opened(gap=0.08, wall=0.02, curl=0.3).write("mud.ply")
