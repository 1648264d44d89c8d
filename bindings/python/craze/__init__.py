"""Surface crack patterns on triangle meshes: mud, glaze, glass, paint.

    import craze
    result = craze.crack(craze.shape("plate?n=60&jitter=0.3"), "mud", seed=7)
    result.mesh.write("mud.ply")

Arrays in, arrays out: see crack(), Mesh and Result. Needs NumPy alone.
"""

from __future__ import annotations

from typing import Any

from ._library import Error, call, text_of
from ._lines import Lines
from ._maps import Maps
from ._mesh import Mesh, read, shape
from ._run import Result, crack
from ._statistics import stats
from ._texture import texture

__version__: str = call("craze_version").decode()

__all__ = [
    "Error",
    "Lines",
    "Maps",
    "Mesh",
    "Result",
    "__version__",
    "crack",
    "parameters",
    "presets",
    "read",
    "shape",
    "stats",
    "texture",
]


def presets() -> dict[str, dict[str, Any]]:
    """{name: recipe}: each preset as a dict that crack() takes."""
    return {name: entry["recipe"] for name, entry in text_of(call("craze_presets")).items()}


def parameters() -> list[dict[str, Any]]:
    """Every key of a recipe: key, type, default, minimum, maximum, choices, unit, help …"""
    listed: list[dict[str, Any]] = text_of(call("craze_parameters"))
    return listed
