"""What operators that crack take: a preset, a recipe, or the panel's."""

from __future__ import annotations

import os
from typing import Any, Callable

import bpy

from .. import panel_recipe, table
from ..work import Problem

FROM_PANEL = "PANEL"
UNITS = {1.0: "m", 0.01: "cm", 0.001: "mm", 1e-6: "um", 0.0254: "in", 0.3048: "ft", 1000.0: "km"}


def _presets(_: Any, __: Any) -> Any:
    return _ITEMS


_ITEMS = [(FROM_PANEL, "As in the panel", "")] + [(name, name, "") for name in table.PRESETS]


def unit_of(scene: Any) -> str | None:
    """The scene's, as mesh.unit has it; None: one without a name. Without a unit system a unit of
    Blender's is a metre, as for its exporters, and the unit scale does not count."""
    units = scene.unit_settings
    if units.system == "NONE":
        return "m"
    return UNITS.get(round(units.scale_length, 6))


class WithRecipe:
    """Mixed into bpy.types.Operator. What is not said comes from the panel; a preset or recipe that
    is said stands for all of the panel's keys."""

    preset: bpy.props.EnumProperty(
        name="Preset", description="Name of a preset", items=_presets, options={"SKIP_SAVE"}
    )
    seed: bpy.props.IntProperty(
        name="Seed",
        description="Of the random numbers; the same seed gives the same bytes. −1: the recipe's",
        min=-1,
        default=-1,
        options={"SKIP_SAVE"},
    )
    spacing: bpy.props.FloatProperty(
        name="Spacing",
        description="Distance between cracks, in the scene's unit; 0: the recipe's",
        min=0.0,
        subtype="DISTANCE",
        unit="LENGTH",
        options={"SKIP_SAVE"},
    )
    recipe: bpy.props.StringProperty(
        name="Recipe",
        description="Path of a .toml file, or the text of a recipe, TOML or JSON",
        options={"SKIP_SAVE"},
    )

    def given_recipe(self, panel: Any, place: Callable[[Any], list[float]]) -> tuple[Any, bool]:
        """The recipe as craze.crack() takes it, and whether it is the text of one; `place` moves
        the panel's places from the scene to the shape that is cracked."""
        preset = self.given_preset()
        if preset and self.recipe:
            raise Problem("give a preset or a recipe, not both")
        if self.recipe:
            if not self.recipe.lower().endswith((".toml", ".json")):
                return self.recipe, True
            return os.path.abspath(bpy.path.abspath(self.recipe)), False
        if preset:
            return preset, False
        return panel_recipe.recipe_of(panel, place), False

    def given_preset(self) -> str:
        """Its name; "" where the recipe or the panel counts."""
        return "" if self.preset == FROM_PANEL else self.preset

    def given_settings(self, scene: Any) -> dict[str, Any]:
        """What is said besides the recipe, and the scene's unit, for lengths such as 4mm; the
        panel's own, where it has one, stands."""
        keys: dict[str, Any] = {}
        unit = unit_of(scene)
        own = not self.given_preset() and not self.recipe and scene.craze.keys.mesh_unit != "none"
        if unit is not None and not own:
            keys["mesh.unit"] = unit
        if self.seed >= 0:
            keys["seed"] = self.seed
        if self.spacing > 0:
            keys["layer.spacing"] = table.as_typed(self.spacing)
        return keys
