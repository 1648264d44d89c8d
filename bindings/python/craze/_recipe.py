"""Recipes as users give them: a preset, a file, a dict, single keys."""

from __future__ import annotations

import json
import os
from typing import Any, Mapping

import numpy as np

from ._library import Error, Handle, call, path_bytes, shown, text_bytes, whole

_SIZE_LIMIT = 1 << 20  # bytes of a recipe; the C interface refuses more


def _plain(value: Any) -> Any:
    if isinstance(value, (np.generic, np.ndarray)):
        return value.tolist()
    raise TypeError


def value_text(key: str, value: Any) -> bytes:
    """A value as JSON; `key` is what messages call it."""
    try:
        return json.dumps(value, ensure_ascii=False, allow_nan=False, default=_plain).encode()
    except (TypeError, ValueError, RecursionError):
        raise Error(
            f"wrong value of {key} ({shown(value)}): must be finite numbers, texts or lists"
        ) from None


def _is_path(recipe: Any) -> bool:
    if isinstance(recipe, str):
        return os.sep in recipe or recipe.endswith((".toml", ".json"))
    return isinstance(recipe, (bytes, os.PathLike))


def set_recipe(job: Handle, recipe: Any) -> None:
    """The whole recipe."""
    if isinstance(recipe, Mapping):
        text = value_text("the recipe", dict(recipe))
        call("craze_job_set_recipe", job.pointer, text, b"recipe")
    elif _is_path(recipe):
        name = path_bytes(recipe)
        try:
            with open(name, "rb") as file:
                text = file.read(_SIZE_LIMIT + 1)
        except OSError as e:
            raise Error(f"cannot read the recipe ({os.fsdecode(name)}): {e.strerror}", "input") from None
        if b"\0" in text:
            raise Error(f"not a recipe ({os.fsdecode(name)}): it holds a zero byte")
        call("craze_job_set_recipe", job.pointer, text, name)
    elif isinstance(recipe, str):
        call("craze_job_set_preset", job.pointer, text_bytes(recipe, "preset"))
    else:
        raise Error(
            f"wrong recipe ({shown(recipe)}): must be the name of a preset, a path, or a dict"
        )


def set_key(job: Handle, key: str, value: Any) -> None:
    """One key, on top of what is set."""
    call("craze_job_set", job.pointer, text_bytes(key, "key"), value_text(key, value))


def set_job(
    job: Handle, recipe: Any, settings: Mapping[str, Any], seed: int | None, threads: int
) -> None:
    """What a run takes besides its mesh, settings after the recipe and the seed last."""
    set_recipe(job, recipe)
    for key, value in settings.items():
        set_key(job, key, value)
    if seed is not None:
        set_key(job, "seed", whole(seed, "seed", 0, 2**53))
    call("craze_job_set_threads", job.pointer, whole(threads, "threads", 0, 1024))
