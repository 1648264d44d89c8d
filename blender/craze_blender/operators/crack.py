"""bpy.ops.craze.crack(): a cracked object of the active one."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np

from .. import cracked, mesh_in, panel_recipe, process, runs, table
from ..work import Problem, Steps
from .base import EngineOperator

FROM_PANEL = "PANEL"
UNITS = {1.0: "m", 0.01: "cm", 0.001: "mm", 0.0254: "in", 0.3048: "ft", 1000.0: "km"}


def _presets(_: Any, __: Any) -> Any:
    return _ITEMS


_ITEMS = [(FROM_PANEL, "As in the panel", "")] + [(name, name, "") for name in table.PRESETS]


class CRAZE_OT_crack(EngineOperator, bpy.types.Operator):
    """Cracks the active object: a new object beside it, or in place. A cracked object is cracked
    anew, from what it was. What is not said comes from the panel; a preset or recipe that is said
    stands for all of the panel's keys"""

    bl_idname = "craze.crack"
    bl_label = "Crack"

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
    in_place: bpy.props.BoolProperty(
        name="In place",
        description="The object itself is cracked; otherwise a new one beside it, which is hidden",
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Any) -> bool:
        thing = context.active_object
        return thing is not None and thing.type == "MESH" and context.mode == "OBJECT"

    def steps(self, context: Any) -> Steps:
        thing = context.active_object
        engine = process.engine()
        again = cracked.is_cracked(thing)
        if again:
            order = cracked.order_of(thing)
            order.run = runs.new_run()
        else:
            order = runs.Order(
                mesh=None,
                groups=cracked.group_names(thing),
                stretch=mesh_in.stretch_of(thing.matrix_world),
                recipe="",
            )
        order.recipe = self._recipe(context.scene.craze, thing, order.stretch)
        order.is_text = bool(self.recipe) and not self._is_path()
        order.settings = self._settings(context.scene.unit_settings.scale_length)
        if not again:
            order.mesh = mesh_in.snapshot(context, thing)
        done = False
        try:
            made = yield from runs.crack(engine, order, f"{thing.name} cracked")
            done = True
        finally:
            if not done and not again:
                bpy.data.meshes.remove(order.mesh)
        if again:
            cracked.replace_mesh(thing, made)
        elif self._in_place(context.scene.craze):
            cracked.adopt(thing, made, order)
        else:
            cracked.new_object(context, thing, made, order)
        for warning in dict.fromkeys(made.warnings + made.report["warnings"]):
            self.report({"WARNING"}, f"craze: {warning}")
        found = made.report["cracks"]
        return f"{found['events']} cracks, {found['fragments']} fragments"

    def _in_place(self, panel: Any) -> bool:
        said = self.properties.is_property_set("in_place")
        return bool(self.in_place if said else panel.in_place)

    def _recipe(self, panel: Any, thing: Any, stretch: np.ndarray) -> Any:
        preset = "" if self.preset == FROM_PANEL else self.preset
        if preset and self.recipe:
            raise Problem("give a preset or a recipe, not both")
        if self.recipe:
            return bpy.path.abspath(self.recipe) if self._is_path() else self.recipe
        if preset:
            return preset
        return panel_recipe.recipe_of(panel, panel_recipe.to_engine(thing.matrix_world, stretch))

    def _is_path(self) -> bool:
        return self.recipe.endswith((".toml", ".json"))

    def _settings(self, metres: float) -> dict[str, Any]:
        """What is said besides the recipe; `metres` is the scene's unit, for lengths such as 4mm."""
        keys: dict[str, Any] = {}
        unit = UNITS.get(round(metres, 6))
        if unit is not None:
            keys["mesh.unit"] = unit
        if self.seed >= 0:
            keys["seed"] = self.seed
        if self.spacing > 0:
            keys["layer.spacing"] = table.as_typed(self.spacing)
        return keys


CLASSES = [CRAZE_OT_crack]
