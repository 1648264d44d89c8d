"""Cracks as lines."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ._library import Array, Handle, view


class Lines:
    """The cracks as a graph on the surface; edges meet only at points. All arrays are read-only.

    Attributes
    ----------
    points : (p, 3) float64
    edges : (e, 2) int32, indices of points; the crack grew from the first to the second
    uv : (e, 2, 2) float64, of both ends of each edge, or None
    time : (e,) float64, the load at which each edge opened
    width : (e,) float64, length, the opening of [IO06 Eq. 9] with γ = 1
    event : (e,) float64, the number of the crack, from 0
    junction : (p,) float64, 0 end, 1 bend, 2 junction, 3 on the border
    normal : (p, 3) float64, unit, of the surface
    """

    def __init__(self, handle: Handle) -> None:
        def get(name: str) -> Array:
            return view(handle, "craze_lines_array", name)

        uv = get("uv")
        self.points: npt.NDArray[np.float64] = get("points")
        self.edges: npt.NDArray[np.int32] = get("edges")
        self.uv: npt.NDArray[np.float64] | None = uv.reshape(-1, 2, 2) if len(uv) else None
        self.time: npt.NDArray[np.float64] = get("edge:time")[:, 0]
        self.width: npt.NDArray[np.float64] = get("edge:width")[:, 0]
        self.event: npt.NDArray[np.float64] = get("edge:event")[:, 0]
        self.junction: npt.NDArray[np.float64] = get("point:junction")[:, 0]
        self.normal: npt.NDArray[np.float64] = get("point:normal")

    def __repr__(self) -> str:
        return f"<craze.Lines of {len(self.points)} points, {len(self.edges)} edges>"
