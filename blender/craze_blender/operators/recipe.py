"""bpy.ops.craze.export_recipe(): the recipe as TOML, for the command."""

from __future__ import annotations

import json
from typing import Any

import bpy

from .. import cracked, panel_recipe, table


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
        thing = context.active_object
        if cracked.is_cracked(thing):
            recipe = json.loads(thing.craze.recipe)
        else:
            recipe = panel_recipe.recipe_of(context.scene.craze, list)
        path = bpy.path.ensure_ext(bpy.path.abspath(self.filepath), ".toml")
        try:
            with open(path, "w", encoding="utf-8") as file:
                file.write(table.toml(recipe))
        except OSError as e:
            self.report({"ERROR"}, f"craze: cannot write {path}: {e.strerror}")
            return {"CANCELLED"}
        self.report({"INFO"}, path)
        return {"FINISHED"}


CLASSES = [CRAZE_OT_export_recipe]
