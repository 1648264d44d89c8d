"""The presets' pictures: pictures/PRESET.png, made by ../preset_pictures.sh."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy.utils.previews

FOLDER = Path(__file__).with_name("pictures")


class _Loaded:
    """Blender's own store of them, between register() and unregister()."""

    pictures: Any = None


def register() -> None:
    _Loaded.pictures = bpy.utils.previews.new()
    for path in sorted(FOLDER.glob("*.png")):
        _Loaded.pictures.load(path.stem, str(path), "IMAGE")


def unregister() -> None:
    bpy.utils.previews.remove(_Loaded.pictures)
    _Loaded.pictures = None


def icon(preset: str) -> int:
    """By which Blender knows the picture; 0: there is none."""
    return _Loaded.pictures[preset].icon_id if preset in _Loaded.pictures else 0
