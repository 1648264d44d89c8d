"""A small picture of a tile, as a library shows it."""

from __future__ import annotations

import numpy as np

SIDE = 256
LIGHT = np.array([-0.4, 0.5, 0.77])  # from above on the left


def tile_preview(maps: dict[str, np.ndarray]) -> np.ndarray:
    """(n, n, 3) float32, sRGB, n at most SIDE: the colour in the light that occlusion and normals
    leave."""
    normal = 2 * maps["normal"] - 1
    shade = np.clip(normal @ LIGHT / LIGHT[2], 0, 1.5) * maps["occlusion"]
    linear = np.clip(_smaller(maps["base_color"] * shade[:, :, None]), 0, 1)
    low = linear <= 0.0031308
    return np.where(low, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055).astype(np.float32)


def _smaller(values: np.ndarray) -> np.ndarray:
    """Means over squares of pixels."""
    step = -(-len(values) // SIDE)
    n = len(values) // step * step
    return values[:n, :n].reshape(n // step, step, n // step, step, -1).mean(axis=(1, 3))
