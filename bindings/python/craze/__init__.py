"""Surface crack patterns on triangle meshes: mud, glaze, glass, paint.

    import craze
    result = craze.crack(craze.shape("plate?n=60&jitter=0.3"), "mud", seed=7)
    result.mesh.write("mud.ply")

Arrays in, arrays out: see crack(), Mesh and Result. Needs NumPy alone.
"""

from __future__ import annotations

from typing import Any

from ._library import Error, call, call_json
from ._mesh import Mesh, read, shape
from ._run import Lines, Result, crack, stats

__version__: str = call("craze_version").decode()

__all__ = [
    "Error",
    "Lines",
    "Mesh",
    "Result",
    "crack",
    "parameters",
    "presets",
    "read",
    "shape",
    "stats",
]


def presets() -> dict[str, dict[str, Any]]:
    """{name: recipe}: each preset as a dict that crack() takes."""
    return {name: entry["recipe"] for name, entry in call_json("craze_presets").items()}


def parameters() -> list[dict[str, Any]]:
    """Every key of a recipe: key, type, default, minimum, maximum, choices, unit, help …"""
    listed: list[dict[str, Any]] = call_json("craze_parameters")
    return listed
