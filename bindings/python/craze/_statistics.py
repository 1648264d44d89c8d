"""Statistics of lines of any origin."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._library import Error, address, call, real, text_of
from ._watch import watched


def stats(
    points: npt.ArrayLike,
    edges: npt.ArrayLike,
    time: npt.ArrayLike | None = None,
    simplify: float = 0.0,
) -> dict[str, Any]:
    """Statistics of crack lines of any origin, such as the skeleton of a photograph.

    Parameters
    ----------
    points : (p, 3), or (p, 2) for lines in a plane
    edges : (e, 2) indices of points
    time : (e,), when each edge opened, or None
    simplify : lines are drawn by as few of their points as stay within this length of them; one
        pixel for a skeleton

    Raises Error for lines that are not in a plane: those of a Result know their surface, use its
    stats().
    """
    given = _arrays.numbers(points, "points")
    if given.ndim == 2 and given.shape[1] == 2:
        given = np.column_stack([given, np.zeros(len(given))])
    at = _arrays.points(given, "points")
    ends = _arrays.indices(edges, 2, len(at), "edges")
    when = None if time is None else _arrays.attribute(time, len(ends), "time")
    if when is not None and when.shape[1] != 1:
        raise Error(f"wrong time (shape {when.shape}): must be ({len(ends)},)")
    length = real(simplify, "simplify")
    result: dict[str, Any] = watched(
        lambda _: text_of(
            call(
                "craze_statistics",
                address(at),
                len(at),
                address(ends),
                len(ends),
                None if when is None else address(when),
                length,
            )
        )
    )
    return result
