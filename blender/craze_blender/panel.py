"""The panel: 3D View, sidebar, "Craze"."""

from __future__ import annotations

import json
from typing import Any

import bpy

from . import cracked, table
from .operators.stats import summary

WIDE = 240  # logical pixels of a sidebar in which labels beside their fields are not cut off
OPENING = ("post.gap", "post.gap_width", "post.wall", "post.curl")


class _Panel:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Craze"

    def _begin(self, context: Any) -> Any:
        """The layout: labels beside the fields where there is room, else within them."""
        layout = self.layout
        scale = context.preferences.system.ui_scale
        layout.use_property_split = context.region.width >= WIDE * scale
        layout.use_property_decorate = False
        return layout


class CRAZE_PT_main(_Panel, bpy.types.Panel):
    bl_label = "Craze"

    def draw(self, context: Any) -> None:
        layout, panel = self._begin(context), context.scene.craze
        layout.template_icon_view(panel, "preset", show_labels=True, scale=5)
        layout.prop(panel, "preset", text="Preset" if layout.use_property_split else "")
        keys = panel.keys
        row = layout.row(align=True)
        row.prop(keys, "seed")
        row.operator("craze.dice", text="", icon="FILE_REFRESH")
        column = layout.column(align=True)
        _key(column, keys, "layer.spacing", "Spacing")
        if keys.layer_spacing == 0 and keys.layer_relative_spacing > 0:
            _key(column, keys, "layer.relative_spacing", "of the size")
        _key(layout, keys, "evolution.max_load", "Load")
        _key(layout, keys, "material.alpha", "Alpha")
        column = layout.column(align=True)
        for key in OPENING:
            _key(column, keys, key)
        layout.prop(panel, "in_place")
        row = layout.row()
        row.scale_y = 1.5
        row.operator("craze.crack", icon="MOD_EXPLODE")
        if cracked.is_cracked(context.active_object):
            layout.prop(panel, "live")


class CRAZE_PT_where(_Panel, bpy.types.Panel):
    bl_label = "Where"
    bl_parent_id = "CRAZE_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: Any) -> None:
        layout, keys = self._begin(context), context.scene.craze.keys
        row = layout.row(align=True)
        row.operator("craze.paint", text="Paint", icon="WPAINT_HLT").selected = False
        row.operator("craze.paint", text="Selected Faces", icon="FACESEL").selected = True
        thing = context.active_object
        for row_ in table.single():
            if row_["section"] == "where" or row_["name"].endswith("attribute"):
                name = table.property_name(row_["key"])
                text = row_["key"].replace(".", " ").replace("_", " ").capitalize()
                if row_["name"].endswith("attribute") and thing is not None:
                    layout.prop_search(keys, name, thing, "vertex_groups", text=text)
                else:
                    layout.prop(keys, name, text=text)
        row = layout.row(align=True)
        row.operator("craze.impact", icon="CURSOR", text="Impact at Cursor")
        row.operator("craze.impact_click", icon="RESTRICT_SELECT_OFF", text="by Click")
        for i, entry in enumerate(keys.impact):
            box = layout.box()
            row = box.row()
            row.label(text=f"Impact {i + 1}")
            row.operator("craze.impact_remove", text="", icon="X").index = i
            for name in entry.__annotations__:
                box.prop(entry, name)


class CRAZE_PT_advanced(_Panel, bpy.types.Panel):
    bl_label = "All Keys"
    bl_parent_id = "CRAZE_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: Any) -> None:
        layout, panel = self._begin(context), context.scene.craze
        layout.prop(panel, "search", text="", icon="VIEWZOOM")
        section = None
        for row in table.single():
            words = f"{row['key']} {row['help']}".lower()
            if panel.search.lower() not in words:
                continue
            if row["section"] != section:
                section = row["section"]
                layout.label(text=section.capitalize() or "Engine")
            layout.prop(panel.keys, table.property_name(row["key"]))
        layout.operator("craze.export_recipe", icon="EXPORT")


class CRAZE_PT_result(_Panel, bpy.types.Panel):
    bl_label = "Result"
    bl_parent_id = "CRAZE_PT_main"

    @classmethod
    def poll(cls, context: Any) -> bool:
        return cracked.is_cracked(context.active_object)

    def draw(self, context: Any) -> None:
        layout, panel = self._begin(context), context.scene.craze
        column = layout.column(align=True)
        for what, value in summary(json.loads(context.active_object.craze.report)):
            row = column.split(factor=0.4 if layout.use_property_split else 0.5)
            row.label(text=what)
            row.label(text=value)
        column = layout.column(align=True)
        column.operator("craze.stats", icon="TEXT")
        column.operator("craze.curves", icon="CURVE_DATA")
        column = layout.column(align=True)
        column.prop(panel, "map_size")
        column.prop(panel, "map_folder")
        column.operator("craze.bake", icon="TEXTURE")
        column = layout.column(align=True)
        column.prop(panel, "thickness")
        column.prop(panel, "core")
        column.operator("craze.pieces", icon="MOD_SOLIDIFY")
        column = layout.column(align=True)
        column.prop(panel, "frames")
        column.prop(panel, "growth")
        column.operator("craze.grow", icon="SHAPEKEY_DATA")


def _key(layout: Any, keys: Any, key: str, text: str | None = None) -> None:
    if table.has(key):
        name = table.property_name(key)
        if text is None:
            layout.prop(keys, name)
        else:
            layout.prop(keys, name, text=text)


CLASSES = [CRAZE_PT_main, CRAZE_PT_where, CRAZE_PT_advanced, CRAZE_PT_result]
