"""Tileable textures: a recipe in, maps out."""

from __future__ import annotations

import os
from typing import Any, Iterable, Mapping

from ._library import Error, Handle, call, shown, text_bytes, whole
from ._maps import Maps, green_up, maps_of, name_list
from ._recipe import set_job
from ._watch import ProgressCallback, check_progress, run


def texture(
    recipe: str | os.PathLike[Any] | Mapping[str, Any] = "mud",
    size: int = 1024,
    period: float | str = 1,
    maps: Iterable[str] | None = None,
    green: str = "up",
    seed: int | None = None,
    threads: int = 0,
    progress: ProgressCallback | None = None,
    **settings: Any,
) -> Maps:
    """A tileable set of textures of a recipe, size × size texels, the first row that of the top
    (v = 1): (size, size) or (size, size, 3). What craze texture writes with --map-format exr.

    recipe, seed, threads, progress, settings : as of crack()
    period : side of the tile: a number in the tile's own unit, or a length such as "40cm"
    maps : names of docs/textures.md; base_color, normal, height, occlusion, roughness, mask and
        fragment where none are given
    green : "up" or "down" with v, of normals

    Raises Error where the recipe asks for what a tile has not. What else could not be done as asked
    is a UserWarning.
    """
    check_progress(progress)
    job = Handle(call("craze_job_new"), "craze_job_free")
    set_job(job, recipe, settings, seed, threads)
    handle: Handle = run(
        job,
        progress,
        "craze_job_texture",
        text_bytes(_side(period), "period"),
        whole(size, "size", 1, 8192),
        name_list(maps),
        green_up(green),
        take=lambda pointer: Handle(pointer, "craze_maps_free"),
    )
    return maps_of(handle)


def _side(period: Any) -> str:
    """As craze.h takes it."""
    if isinstance(period, str):
        return period
    try:
        return repr(float(period))
    except (TypeError, ValueError):
        raise Error(
            f"wrong period ({shown(period)}): must be a number, or a text such as 40cm"
        ) from None
