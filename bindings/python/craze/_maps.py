"""Maps: textures of the cracks for the mesh's own UVs."""

from __future__ import annotations

import ctypes
import warnings
from typing import Any, Dict, Iterable

import numpy as np
import numpy.typing as npt

from ._library import CArray, Error, Handle, call, listed, shown, text_bytes

GREEN = {"up": 1, "down": 0}


def name_list(maps: Iterable[str] | None) -> bytes | None:
    """The names with commas between them, as craze.h takes them; None: all maps."""
    if maps is None:
        return None
    names = [maps] if isinstance(maps, str) else list(maps)
    if not names:
        raise Error("wrong maps ([]): name one at least, or none at all for all of them")
    return b",".join(text_bytes(name, "name of a map") for name in names)


def green_up(green: Any) -> int:
    """1 or 0 of "up" or "down"."""
    if not isinstance(green, str) or green not in GREEN:
        raise Error(f'wrong green ({shown(green)}): must be "up" or "down"')
    return GREEN[green]


class Maps(Dict[str, npt.NDArray[np.float32]]):
    """Maps by name: (size, size), or (size, size, 3), float32.

    Attributes
    ----------
    description : what each of them is, the text of maps.json (docs/maps.md) as the command writes it
        beside them with --map-format exr
    """

    description: str = ""


def maps_of(handle: Handle) -> Maps:
    """Copies of all maps; what could not be done as asked is a UserWarning of the caller's caller."""
    result = Maps()
    result.description = call("craze_maps_description", handle.pointer).decode("utf-8", "replace")
    for i, name in enumerate(listed("craze_maps_name", handle.pointer)):
        array = CArray()
        call("craze_maps_array", handle.pointer, i, ctypes.byref(array))
        size = round(array.rows**0.5)
        numbers = (ctypes.c_float * (array.rows * array.columns)).from_address(array.data)
        shape = (size, size) if array.columns == 1 else (size, size, array.columns)
        result[name] = np.array(numbers, dtype=np.float32).reshape(shape)
    for sentence in listed("craze_maps_warning", handle.pointer):
        warnings.warn(sentence, UserWarning, stacklevel=3)
    return result
