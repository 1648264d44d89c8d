"""bpy.ops.craze.export_recipe(): the recipe as TOML, for the command."""

from __future__ import annotations

import json
from typing import Any

import bpy

from .. import cracked, mesh_in, panel_recipe, table
from ..work import Problem
from .recipe_options import unit_of


class CRAZE_OT_export_recipe(bpy.types.Operator):
    """Writes the recipe of the cracked object, or that of the panel, as TOML"""

    bl_idname = "craze.export_recipe"
    bl_label = "Export Recipe"

    filepath: bpy.props.StringProperty(subtype="FILE_PATH", options={"SKIP_SAVE"})
    filter_glob: bpy.props.StringProperty(default="*.toml", options={"HIDDEN"})

    def invoke(self, context: Any, _: Any) -> set[str]:
        self.filepath = self.filepath or "recipe.toml"
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Any) -> set[str]:
        try:
            path = self._path()
            recipe = _recipe(context)
        except Problem as e:
            self.report({"ERROR"}, f"craze: {e}")
            return {"CANCELLED"}
        try:
            with open(path, "w", encoding="utf-8") as file:
                file.write(table.toml(recipe))
        except OSError as e:
            self.report({"ERROR"}, f"craze: cannot write {path}: {e.strerror}")
            return {"CANCELLED"}
        self.report({"INFO"}, path)
        return {"FINISHED"}

    def _path(self) -> str:
        if not self.filepath:
            raise Problem("say where to write the recipe: filepath=")
        if self.filepath.startswith("//") and not bpy.data.is_saved:
            raise Problem(f"{self.filepath} is beside the file, which was never saved")
        return bpy.path.ensure_ext(bpy.path.abspath(self.filepath), ".toml")


def _recipe(context: Any) -> dict[str, Any]:
    """That of the cracked object, or the panel's as *Crack* would take it for the active one."""
    thing, panel = context.active_object, context.scene.craze
    if cracked.is_cracked(thing):
        recipe: dict[str, Any] = json.loads(thing.craze.recipe)
        return recipe
    place: Any = list
    if thing is not None and thing.type == "MESH":
        stretch = mesh_in.stretch_of(thing.matrix_world)
        place = panel_recipe.to_engine(thing.matrix_world, stretch)
    recipe = panel_recipe.recipe_of(panel, place)
    unit = unit_of(context.scene)
    if unit is not None and panel.keys.mesh_unit == "none":
        table.put(recipe, "mesh.unit", unit)
    return recipe


CLASSES = [CRAZE_OT_export_recipe]
