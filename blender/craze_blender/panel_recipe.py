"""Between the panel and a recipe: what its properties say as a recipe, and a recipe as its
properties."""

from __future__ import annotations

import copy
import json
from typing import Any, Callable

import numpy as np
from mathutils import Vector

from . import table

LARGEST = 2**31 - 1  # of Blender's whole numbers


def is_vector(row: dict[str, Any]) -> bool:
    """Always so many numbers; one that may be none is a text."""
    return row["type"] in {"vec2", "vec3", "tensor6"} and len(row["default"]) > 0


def _from_property(row: dict[str, Any], value: Any) -> Any:
    """A property's value as a recipe has it."""
    kind = row["type"]
    if kind in {"boolean", "choice", "integer"}:
        return value
    if isinstance(value, float):
        return table.as_typed(value)
    if not isinstance(value, str):
        return [table.as_typed(x) for x in value]
    if kind == "string":
        return value
    if kind == "names":
        return [name.strip() for name in value.split(",") if name.strip()]
    try:
        return json.loads(value)  # "0.02", "[]"
    except ValueError:
        return value  # "auto"


def to_property(row: dict[str, Any], value: Any) -> Any:
    kind = row["type"]
    if kind == "integer":
        return int(min(value, LARGEST))
    if kind in {"boolean", "choice", "string"} or is_vector(row):
        return value
    if kind == "names":
        return ", ".join(value)
    if kind in {"real", "length"} and isinstance(row["default"], (int, float)):
        # A preset's "8%" stays the preset's as long as the number is not touched.
        return row["default"] if isinstance(value, str) else value
    return value if isinstance(value, str) else json.dumps(value)


def _same(row: dict[str, Any], held: Any, value: Any) -> bool:
    """A property holds a value, as well as it can."""
    as_held = to_property(row, value)
    if isinstance(held, str) or isinstance(as_held, str):
        return bool(held == as_held)
    return bool((np.float32(held) == np.float32(as_held)).all())


def to_engine(matrix: Any, stretch: np.ndarray) -> Callable[[Any], list[float]]:
    """From places in the scene to those of the shape that is cracked (mesh_in.stretch_of)."""
    back = matrix.inverted_safe()

    def place(point: Any) -> list[float]:
        return [float(x) for x in np.array(back @ Vector(point)) @ stretch]

    return place


def recipe_of(settings: Any, place: Callable[[Any], list[float]]) -> dict[str, Any]:
    """The panel's recipe: the preset's own numbers where nothing was changed, so that the same
    bytes come out as from the command, and what is changed takes back what says the same in another
    way. Points of impacts are in the scene; `place` moves them."""
    recipe = copy.deepcopy(table.PRESETS[settings.preset])
    single = {row["key"]: row for row in table.single()}
    changed = []
    for row in single.values():
        held = getattr(settings.keys, table.property_name(row["key"]))
        value = table.value_in(recipe, row["key"])
        value = row["default"] if value is None else value
        if not _same(row, held, value):
            table.put(recipe, row["key"], _from_property(row, held))
            changed.append(row)
    for row in changed:
        other = single.get(row["instead_of"])
        if other and other not in changed:
            table.put(recipe, other["key"], other["default"])
    for section, rows in table.repeated().items():
        entries = getattr(settings.keys, section)
        old = recipe.get(section, [])
        recipe[section] = [
            _entry(rows, entry, old[i] if i < len(old) else {}, place)
            for i, entry in enumerate(entries)
        ]
    return recipe


def _entry(rows: list[dict[str, Any]], entry: Any, old: dict[str, Any], place: Any) -> dict[str, Any]:
    made = {}
    for row in rows:
        held, known = getattr(entry, row["name"]), old.get(row["name"], row["default"])
        made[row["name"]] = known if _same(row, held, known) else _from_property(row, held)
    made["point"] = place(made["point"])
    return made


def show(settings: Any, recipe: dict[str, Any]) -> None:
    """Puts a recipe into the panel."""
    for row in table.single():
        value = table.value_in(recipe, row["key"])
        value = row["default"] if value is None else value
        setattr(settings.keys, table.property_name(row["key"]), to_property(row, value))
    for section, rows in table.repeated().items():
        entries = getattr(settings.keys, section)
        entries.clear()
        for known in recipe.get(section, []):
            entry = entries.add()
            for row in rows:
                if row["name"] in known:
                    setattr(entry, row["name"], to_property(row, known[row["name"]]))
