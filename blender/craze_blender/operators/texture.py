"""bpy.ops.craze.texture(): a tileable material, as an asset."""

from __future__ import annotations

import os
import shutil
from typing import Any

import bpy

from .. import assets, map_images, process, runs, table, tile_material
from ..work import Problem, Steps
from ..world import remove
from .base import EngineOperator
from .recipe_options import WithRecipe

ROOT = "Craze"  # the catalogue that has one of each preset


class CRAZE_OT_texture(WithRecipe, EngineOperator, bpy.types.Operator):
    """Makes tileable images of a preset, and a material of them that is an asset, with a preview,
    tags and a catalogue. No object is needed. What is not said comes from the panel"""

    bl_idname = "craze.texture"
    bl_label = "Tileable Material"
    of_object = False

    period: bpy.props.FloatProperty(
        name="Tile",
        description="Side of the tile, in the scene's unit",
        min=1e-6,
        default=1.0,
        subtype="DISTANCE",
        unit="LENGTH",
        options={"SKIP_SAVE"},
    )
    size: bpy.props.IntProperty(
        name="Size", description="Of the images, pixels a side", min=1, max=8192, options={"SKIP_SAVE"}
    )
    directory: bpy.props.StringProperty(
        name="Library",
        description="Folder of an asset library: the asset is a file there, beside a list of "
        "catalogues; empty: it is in this file",
        subtype="DIR_PATH",
        options={"SKIP_SAVE"},
    )

    def steps(self, context: Any) -> Steps:
        panel, engine = context.scene.craze, process.engine()
        size = self._said("size", panel.map_size)
        period = table.as_typed(self._said("period", panel.tile))
        given = self._said("directory", panel.library)
        if given.startswith("//") and not bpy.data.is_saved:
            raise Problem(f"{given} is beside the file, which was never saved")
        recipe, is_text = self.given_recipe(panel, list)
        preset = "" if self.recipe else self.given_preset() or panel.preset
        title = preset.replace("-", " ").capitalize() or "Cracks"
        folder = os.path.join(engine.folder, f"tile-{runs.new_run()}")
        made: list[Any] = []  # to be removed where it does not get ready
        done = False
        try:
            tile = yield from runs.texture(
                engine, recipe, is_text, self.given_settings(context.scene), size, period, folder
            )
            images = {}
            for file in tile.files:
                [((_, name), image)] = map_images.load([file], f"{title} tile", pack=True).items()
                images[name] = image
                made.insert(0, image)
                yield
            material = tile_material.new(f"{title} tile", images)
            made.insert(0, material)
            path = f"{ROOT}/{title}"
            text = f"{table.DESCRIPTIONS.get(preset, 'Cracks')}; a tile is {period:g} a side"
            tags = ["cracks", "tileable", *filter(None, [preset])]
            assets.mark(material, path, tags, text, tile.preview)
            where = "an asset of this file"
            if given:
                yield
                where = assets.write(material, bpy.path.abspath(given), path)
                material.asset_clear()  # this file has a material; the asset is the library's
                material.use_fake_user = True
            done = True
        finally:
            shutil.rmtree(folder, ignore_errors=True)
            if not done:
                remove(made)
        for warning in tile.warnings:
            self.report({"WARNING"}, f"craze: {warning}")
        return f"{material.name}, {size} × {size} pixels: {where}"

    def _said(self, name: str, otherwise: Any) -> Any:
        return getattr(self, name) if self.properties.is_property_set(name) else otherwise


CLASSES = [CRAZE_OT_texture]
