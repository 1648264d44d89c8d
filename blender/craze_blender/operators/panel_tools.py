"""Small operators of the panel: a dice, and where it cracks."""

from __future__ import annotations

import random
from typing import Any

import bpy

from ..cracked import is_cracked

PAINTED = "Cracks"  # the vertex group that is painted


class CRAZE_OT_dice(bpy.types.Operator):
    """Another seed"""

    bl_idname = "craze.dice"
    bl_label = "New Seed"
    bl_options = {"UNDO"}

    def execute(self, context: Any) -> set[str]:
        context.scene.craze.keys.seed = random.randrange(1, 100000)
        return {"FINISHED"}


class CRAZE_OT_paint(bpy.types.Operator):
    """Makes a vertex group, 1 everywhere or on the selected faces alone, which says where it cracks:
    0 nowhere, 1 freely; and starts weight paint"""

    bl_idname = "craze.paint"
    bl_label = "Paint Where"
    bl_options = {"UNDO"}

    selected: bpy.props.BoolProperty(
        name="Selected faces", description="1 on the selected faces, 0 elsewhere; no painting"
    )

    @classmethod
    def poll(cls, context: Any) -> bool:
        thing = context.active_object
        modes = {"OBJECT", "EDIT_MESH"}
        if is_cracked(thing):
            cls.poll_message_set("craze: paint on what this was cracked from, which is hidden")
            return False
        if thing is not None and thing.type == "MESH" and context.mode in modes:
            return True
        cls.poll_message_set("craze: select a mesh, in Object or Edit Mode")
        return False

    def execute(self, context: Any) -> set[str]:
        thing = context.active_object
        editing = thing.mode == "EDIT"
        if editing:  # where groups cannot be changed, and the selection is not in the mesh yet
            bpy.ops.object.mode_set(mode="OBJECT")
        group = thing.vertex_groups.get(PAINTED)
        new = group is None
        if new:
            group = thing.vertex_groups.new(name=PAINTED)
        everywhere = list(range(len(thing.data.vertices)))
        if self.selected:
            group.add(everywhere, 0.0, "REPLACE")
            chosen = {v for p in thing.data.polygons if p.select for v in p.vertices}
            group.add(sorted(chosen), 1.0, "REPLACE")
        elif new:
            group.add(everywhere, 1.0, "REPLACE")
        thing.vertex_groups.active = group
        context.scene.craze.keys.where_attribute = PAINTED
        if self.selected and editing:
            bpy.ops.object.mode_set(mode="EDIT")
        if not self.selected and not bpy.app.background:
            bpy.ops.object.mode_set(mode="WEIGHT_PAINT")
        return {"FINISHED"}


CLASSES = [CRAZE_OT_dice, CRAZE_OT_paint]
