"""A photograph's skeleton beside a simulation: the same statistics of both.

The skeleton is a picture, 1 where a line runs, one pixel wide, as skimage.morphology.skeletonize()
gives it; here it is drawn: a wall of bricks.
"""

import numpy as np

import craze

skeleton = np.zeros((121, 161), bool)
skeleton[::20, :] = True
for course in range(6):
    skeleton[20 * course : 20 * course + 20, 20 * (course % 2) :: 40] = True

# Pixels that touch are joined: to the right, and down.
number = np.full(skeleton.shape, -1)
number[skeleton] = np.arange(skeleton.sum())
right = np.stack([number[:, :-1], number[:, 1:]], axis=-1).reshape(-1, 2)
down = np.stack([number[:-1], number[1:]], axis=-1).reshape(-1, 2)
edges = np.concatenate([right, down])
edges = edges[(edges >= 0).all(axis=1)]
points = np.argwhere(skeleton)[:, ::-1].astype(float)  # x, y in pixels

photograph = craze.stats(points, edges, simplify=1.0)
simulated = craze.crack(craze.shape("plate?n=40&jitter=0.3"), "mud", seed=7).stats()
for name, found in (("photograph", photograph), ("simulated", simulated)):
    degree, counts = found["nodes"]["mean_degree"], found["counts"]
    print(f"{name}: {counts['junctions']} junctions of {degree['value']:.2f} ± {degree['error']:.2f}")
