"""Growth as frames: the same mesh at eight moments, from no crack to all of them.

Faces and attributes are the same in each; only the vertices move.
"""

import numpy as np

import craze

result = craze.crack(craze.shape("plate?n=30&jitter=0.3"), "mud", seed=7)
frame = result.opened(gap=0.1)
for i, t in enumerate(np.linspace(0, 1, 8)):
    frame.vertices = result.positions_at(t, gap=0.1)
    frame.write(f"frame_{i:04d}.ply")
