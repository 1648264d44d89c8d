"""The operators, bpy.ops.craze.*: a file each."""

from __future__ import annotations

import bpy

from . import bake, base, crack, curves, grow, impact, panel_tools, pieces, recipe, stats, texture

MODULES = (crack, bake, texture, pieces, grow, curves, stats, recipe, impact, panel_tools)


def register() -> None:
    for module in MODULES:
        for cls in module.CLASSES:
            bpy.utils.register_class(cls)


def unregister() -> None:
    base.stop()
    for module in reversed(MODULES):
        for cls in reversed(module.CLASSES):
            bpy.utils.unregister_class(cls)
