"""bpy.ops.craze.impact…(): where something hits, at the 3D cursor or where a user clicks."""

from __future__ import annotations

from typing import Any

import bpy
from bpy_extras import view3d_utils


class CRAZE_OT_impact(bpy.types.Operator):
    """Adds an impact at the 3D cursor"""

    bl_idname = "craze.impact"
    bl_label = "Impact at 3D Cursor"
    bl_options = {"UNDO"}

    def execute(self, context: Any) -> set[str]:
        context.scene.craze.keys.impact.add().point = context.scene.cursor.location
        return {"FINISHED"}


class CRAZE_OT_impact_click(bpy.types.Operator):
    """Adds an impact where you click on a surface"""

    bl_idname = "craze.impact_click"
    bl_label = "Impact by Click"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.area is not None and context.area.type == "VIEW_3D"

    def invoke(self, context: Any, _: Any) -> set[str]:
        context.window.cursor_modal_set("CROSSHAIR")
        context.workspace.status_text_set("Click on a surface   (Esc: none)")
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> set[str]:
        if event.type in {"ESC", "RIGHTMOUSE"}:
            self._end(context)
            return {"CANCELLED"}
        if event.type != "LEFTMOUSE" or event.value != "PRESS":
            return {"PASS_THROUGH"}  # a view can be turned meanwhile
        point = _under(context, event)
        if point is None:
            self.report({"WARNING"}, "craze: there is no surface")
            return {"RUNNING_MODAL"}
        self._end(context)
        context.scene.craze.keys.impact.add().point = point
        return {"FINISHED"}

    def cancel(self, context: Any) -> None:
        """Blender closes or reads another file."""
        self._end(context)

    def _end(self, context: Any) -> None:
        context.window.cursor_modal_restore()
        context.workspace.status_text_set(None)


def _under(context: Any, event: Any) -> Any:
    """The point of a surface, in the scene, that is seen where the mouse is; None: there is none."""
    region = next((r for r in context.area.regions if r.type == "WINDOW"), None)
    if region is None:
        return None
    view = context.area.spaces.active.region_3d
    place = event.mouse_x - region.x, event.mouse_y - region.y
    origin = view3d_utils.region_2d_to_origin_3d(region, view, place)
    direction = view3d_utils.region_2d_to_vector_3d(region, view, place)
    hit, point, *_ = context.scene.ray_cast(
        context.evaluated_depsgraph_get(), origin, direction
    )
    return point if hit else None


class CRAZE_OT_impact_remove(bpy.types.Operator):
    """Removes an impact"""

    bl_idname = "craze.impact_remove"
    bl_label = "Remove Impact"
    bl_options = {"UNDO"}

    index: bpy.props.IntProperty()

    def execute(self, context: Any) -> set[str]:
        context.scene.craze.keys.impact.remove(self.index)
        return {"FINISHED"}


CLASSES = [CRAZE_OT_impact, CRAZE_OT_impact_click, CRAZE_OT_impact_remove]
