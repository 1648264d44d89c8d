"""Whether somebody changed an object since: what Crack made, or what it took."""

from __future__ import annotations

import zlib
from typing import Any

import bpy

from . import layers, weights
from .mesh_in import modifiers_to_apply
from .work import Steps, holding, last
from .world import remove


def digest(mesh: Any, groups: int) -> Steps:
    """A text that is another one when shape, layers, shape keys, or weights of `groups` vertex
    groups change; of a mesh that nobody else has, in steps. Other versions of Blender give others."""
    found = 0
    with holding(mesh):
        for name, values in layers.all_of(mesh):
            found = zlib.crc32(values.tobytes(), zlib.crc32(name.encode(), found))
            yield
        read = yield from last(weights.read_groups(mesh, groups))
    for group in read:
        found = zlib.crc32(group.tobytes(), found)
    return f"{_version()} {found:08x}"


def edited(thing: Any) -> Steps:
    """Whether the mesh of a cracked object is another one than was made; not known, no, where
    another Blender made it."""
    made = thing.craze.digest
    if not made.startswith(_version() + " "):
        return False
    return made != (yield from _now(thing))


class Before:
    """An object as it is now; `taken`: its snapshot."""

    def __init__(self, thing: Any, taken: Any) -> None:
        self._groups = len(thing.vertex_groups)
        self._modifiers = _settings_of(thing)
        self._own = thing.data.copy() if self._modifiers else None
        self._mesh = taken if self._own is None else self._own

    def changed(self, thing: Any) -> Steps:
        """Whether the object is another one by now."""
        if _settings_of(thing) != self._modifiers:
            return True
        return (yield from digest(self._mesh, self._groups)) != (yield from _now(thing))

    def kept(self) -> list[Any]:
        """What is to be removed then, besides the snapshot."""
        return [] if self._own is None else [self._own]


def _now(thing: Any) -> Steps:
    """The digest of what an object has."""
    groups, copy = len(thing.vertex_groups), thing.data.copy()
    try:
        return (yield from digest(copy, groups))
    finally:
        remove([copy])


def _settings_of(thing: Any) -> list[Any]:
    """What modifiers that are applied say; of nodes their inputs too."""
    return [
        [
            modifier.type,
            *(repr(getattr(modifier, name)) for name in _names(modifier)),
            *((key, _plain(modifier[key])) for key in _inputs(modifier)),
        ]
        for modifier in modifiers_to_apply(thing)
    ]


def _inputs(modifier: Any) -> list[str]:
    return list(modifier.keys()) if modifier.type == "NODES" else []


def _plain(value: Any) -> str:
    """As it can be compared: arrays of Blender's are equal to themselves alone."""
    return repr(value.to_list() if hasattr(value, "to_list") else value)


def _names(modifier: Any) -> list[str]:
    simple = {"BOOLEAN", "INT", "FLOAT", "STRING", "ENUM"}
    return [
        p.identifier
        for p in modifier.bl_rna.properties
        if p.type in simple and not getattr(p, "is_array", False) and p.identifier not in _SHOWN
    ]


_SHOWN = {"show_expanded", "is_active", "execution_time"}  # of the interface alone


def _version() -> str:
    return ".".join(map(str, bpy.app.version[:2]))
