"""The panel: 3D View, sidebar, "Craze"."""

from __future__ import annotations

import json
import textwrap
from typing import Any

import bpy

from . import cracked, progress, table
from .operators.stats import summary

WIDE = 240  # logical pixels of a sidebar in which labels beside their fields are not cut off
NARROW = 180  # and in which labels within their fields are cut off: they are above
LETTER, ICON = 7, 60  # logical pixels of one, and of an icon with what is beside lines
OPENING = ("post.gap", "post.gap_width", "post.wall", "post.curl", "post.roughness")


class _View:
    """A panel's layout: labels beside the fields where there is room, else within them, else above."""

    def __init__(self, layout: Any, context: Any) -> None:
        width = context.region.width / context.preferences.system.ui_scale
        layout.use_property_split = self.wide = width >= WIDE
        layout.use_property_decorate = False
        self.layout = layout
        self.narrow = width < NARROW
        self.letters = max(int((width - ICON) / LETTER), 10)  # of a line

    def column(self) -> Any:
        return self.layout.column(align=True)

    def prop(self, layout: Any, data: Any, name: str, text: str | None = None) -> None:
        shown = data.bl_rna.properties[name]
        text = shown.name if text is None else text
        if self.narrow and shown.type != "BOOLEAN" and text:
            layout.label(text=text)
            text = ""
        layout.prop(data, name, text=text)

    def key(self, layout: Any, keys: Any, key: str, text: str | None = None) -> None:
        if table.row_of(key):
            self.prop(layout, keys, table.property_name(key), text)

    def row(self, layout: Any) -> Any:
        """Of two buttons: one below the other where it is narrow."""
        return layout.column(align=True) if self.narrow else layout.row(align=True)

    def fact(self, layout: Any, what: str, value: str) -> None:
        if self.narrow:
            layout.label(text=f"{what}:")
            layout.label(text=f"   {value}")
            return
        row = layout.split(factor=0.4 if self.wide else 0.45)
        row.label(text=what)
        row.label(text=value)


    def words(self, text: str, icon: str) -> None:
        """A sentence, in as many lines as it takes."""
        column = self.layout.column(align=True)
        for i, line in enumerate(textwrap.wrap(text, self.letters)):
            column.label(text=line, icon="BLANK1" if i else icon)


class _Panel:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Craze"


class CRAZE_PT_main(_Panel, bpy.types.Panel):
    bl_label = "Craze"

    def draw(self, context: Any) -> None:
        view, panel = _View(self.layout, context), context.scene.craze
        layout = view.layout
        layout.template_icon_view(panel, "preset", show_labels=True, scale=5)
        layout.prop(panel, "preset", text="Preset" if view.wide else "")
        keys = panel.keys
        column = view.column()
        if view.narrow:
            column.label(text="Seed")
        row = column.row(align=True)
        row.prop(keys, "seed", text="" if view.narrow else "Seed")
        row.operator("craze.dice", text="", icon="FILE_REFRESH")
        column = view.column()
        view.key(column, keys, "layer.spacing", "Spacing")
        if keys.layer_spacing == 0 and keys.layer_relative_spacing > 0:
            view.key(column, keys, "layer.relative_spacing", "of the size")
        column = view.column()
        view.key(column, keys, "evolution.max_load", "Load")
        view.key(column, keys, "material.alpha", "Alpha")
        column = view.column()
        for key in OPENING:
            view.key(column, keys, key)
        layout.prop(panel, "in_place")
        row = layout.row()
        row.scale_y = 1.5
        row.operator("craze.crack", icon="MOD_EXPLODE")
        text, failed = progress.shown()
        view.words(text, "ERROR" if failed else "TIME")
        if cracked.is_cracked(context.active_object):
            layout.prop(panel, "live")
            if context.active_object.craze.edited:
                view.words("Changed by hand: Crack makes a new object", "INFO")


class CRAZE_PT_where(_Panel, bpy.types.Panel):
    bl_label = "Where"
    bl_parent_id = "CRAZE_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: Any) -> None:
        view, keys = _View(self.layout, context), context.scene.craze.keys
        layout = view.layout
        row = view.row(layout)
        row.operator("craze.paint", text="Paint", icon="WPAINT_HLT").selected = False
        row.operator("craze.paint", text="Selected Faces", icon="FACESEL").selected = True
        places = [row for row in table.single() if row["section"] == "where"]
        others = [row for row in table.single() if row["name"].endswith("attribute")]
        column = view.column()
        for row_ in places:
            self._place(view, column, context, row_, _words(row_["name"]))
        layout.label(text="By attributes")
        column = view.column()
        for row_ in others:
            if row_ not in places:
                name = row_["name"].removesuffix("attribute") or row_["section"]
                self._place(view, column, context, row_, _words(name))
        layout.label(text="Impacts")
        row = view.row(layout)
        row.operator("craze.impact", icon="CURSOR", text="At Cursor")
        row.operator("craze.impact_click", icon="RESTRICT_SELECT_OFF", text="By Click")
        for i, entry in enumerate(keys.impact):
            box = layout.box()
            row = box.row()
            row.label(text=f"Impact {i + 1}")
            row.operator("craze.impact_remove", text="", icon="X").index = i
            column = box.column(align=True)
            for name in entry.__annotations__:
                view.prop(column, entry, name)

    def _place(self, view: _View, layout: Any, context: Any, row: dict[str, Any], text: str) -> None:
        keys, name = context.scene.craze.keys, table.property_name(row["key"])
        if not row["name"].endswith("attribute") or context.active_object is None:
            view.prop(layout, keys, name, text)
            return
        if view.narrow:
            layout.label(text=text)
            text = ""
        layout.prop_search(keys, name, context.active_object, "vertex_groups", text=text)


class CRAZE_PT_advanced(_Panel, bpy.types.Panel):
    bl_label = "All Keys"
    bl_parent_id = "CRAZE_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: Any) -> None:
        view, panel = _View(self.layout, context), context.scene.craze
        view.layout.prop(panel, "search", text="", icon="VIEWZOOM")
        section = None
        column = view.column()
        for row in found(panel.search):
            if row["section"] != section:
                section = row["section"]
                view.layout.label(text=section.capitalize() or "Engine")
                column = view.column()
            view.prop(column, panel.keys, table.property_name(row["key"]))
        view.layout.operator("craze.export_recipe", icon="EXPORT")


class CRAZE_PT_texture(_Panel, bpy.types.Panel):
    bl_label = "Tileable Material"
    bl_parent_id = "CRAZE_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: Any) -> None:
        view, panel = _View(self.layout, context), context.scene.craze
        column = view.column()
        view.prop(column, panel, "tile")
        view.prop(column, panel, "map_size")
        view.prop(column, panel, "library")
        column.operator("craze.texture", text="Make Asset", icon="ASSET_MANAGER")


class CRAZE_PT_result(_Panel, bpy.types.Panel):
    bl_label = "Result"
    bl_parent_id = "CRAZE_PT_main"

    @classmethod
    def poll(cls, context: Any) -> bool:
        return cracked.is_cracked(context.active_object)

    def draw(self, context: Any) -> None:
        view, panel = _View(self.layout, context), context.scene.craze
        column = view.column()
        for what, value in summary(json.loads(context.active_object.craze.report)):
            view.fact(column, what, value)
        column = view.column()
        column.operator("craze.stats", icon="TEXT")
        column.operator("craze.curves", icon="CURVE_DATA")
        for properties, operator, icon in (
            (("map_size", "map_folder"), "craze.bake", "TEXTURE"),
            (("thickness", "core"), "craze.pieces", "MOD_SOLIDIFY"),
            (("frames", "growth"), "craze.grow", "SHAPEKEY_DATA"),
        ):
            column = view.column()
            for name in properties:
                view.prop(column, panel, name)
            column.operator(operator, icon=icon)


def found(words: str) -> list[dict[str, Any]]:
    """The keys that have some words in their name or help."""
    wanted = words.strip().lower()
    return [
        row
        for row in table.single()
        if wanted in f"{row['key']} {_words(row['name'])} {row['help']}".lower()
    ]


def _words(name: str) -> str:
    return name.replace("_", " ").strip().capitalize()


CLASSES = [CRAZE_PT_main, CRAZE_PT_where, CRAZE_PT_advanced, CRAZE_PT_texture, CRAZE_PT_result]
