"""The engine's own table of parameters and its presets, which the build wrote to table.json."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

_READ = json.loads(Path(__file__).with_name("table.json").read_text(encoding="utf-8"))

VERSION: str = _READ["version"]
PARAMETERS: list[dict[str, Any]] = _READ["parameters"]
PRESETS: dict[str, dict[str, Any]] = _READ["presets"]
DESCRIPTIONS: dict[str, str] = _READ["descriptions"]
FIRST_PRESET = "mud"


def property_name(key: str) -> str:
    """Of a key: layer.spacing → layer_spacing."""
    return key.replace(".", "_")


def single() -> list[dict[str, Any]]:
    """The keys that a recipe has once."""
    return [row for row in PARAMETERS if not row["repeated"]]


def repeated() -> dict[str, list[dict[str, Any]]]:
    """The sections that a recipe may have several of, each with its keys."""
    sections: dict[str, list[dict[str, Any]]] = {}
    for row in PARAMETERS:
        if row["repeated"]:
            sections.setdefault(row["section"], []).append(row)
    return sections


def row_of(key: str) -> dict[str, Any] | None:
    return next((row for row in PARAMETERS if row["key"] == key), None)


def value_in(recipe: dict[str, Any], key: str) -> Any:
    """What a recipe says of a key; None: nothing."""
    section, _, name = key.rpartition(".")
    return recipe.get(section, {}).get(name) if section else recipe.get(name)


def put(recipe: dict[str, Any], key: str, value: Any) -> None:
    section, _, name = key.rpartition(".")
    (recipe.setdefault(section, {}) if section else recipe)[name] = value


def as_typed(value: float) -> float:
    """The shortest number that a float of Blender's shows as: 0.07, not 0.07000000029802322."""
    return float(str(np.float32(value)))


def toml(recipe: dict[str, Any]) -> str:
    """A recipe as TOML."""

    def text(value: Any) -> str:
        if isinstance(value, float) and value == int(value) and abs(value) < 1e15:
            return f"{value:.1f}"
        return json.dumps(value, ensure_ascii=False)

    def lines(section: dict[str, Any]) -> str:
        return "".join(f"{name} = {text(value)}\n" for name, value in section.items())

    plain = {k: v for k, v in recipe.items() if not isinstance(v, (dict, list))}
    out = lines(plain)
    for name, value in recipe.items():
        if isinstance(value, dict):
            out += f"\n[{name}]\n{lines(value)}"
        elif isinstance(value, list):
            out += "".join(f"\n[[{name}]]\n{lines(entry)}" for entry in value)
    return out
