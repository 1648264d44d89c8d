"""bpy.ops.craze.bake(): the cracks as images, and materials that show them."""

from __future__ import annotations

import os
import shutil
from typing import Any

import bpy

from .. import cracked, cracked_material, map_images, process, runs
from ..work import Problem, Steps
from .base import OfCracked


class CRAZE_OT_bake(OfCracked, bpy.types.Operator):
    """Bakes the cracks to images for the object's active UV map, and gives it materials that show
    them by the node group "Craze Cracks": colour, depth and stains"""

    bl_idname = "craze.bake"
    bl_label = "Bake"

    size: bpy.props.IntProperty(
        name="Size", description="Of the images, pixels a side", min=1, max=8192, options={"SKIP_SAVE"}
    )
    directory: bpy.props.StringProperty(
        name="Folder",
        description="Where all maps are written, as .exr; empty: those that the material shows, "
        "packed into the .blend",
        subtype="DIR_PATH",
        options={"SKIP_SAVE"},
    )

    def steps(self, context: Any) -> Steps:
        thing, panel, engine = context.active_object, context.scene.craze, process.engine()
        cracked.check_own(thing)
        said = self.properties.is_property_set
        size = self.size if said("size") else panel.map_size
        given = self.directory if said("directory") else panel.map_folder
        if given.startswith("//") and not bpy.data.is_saved:
            raise Problem(f"{given} is beside the file, which was never saved")
        order = cracked.order_of(thing)
        post = cracked.post_of(thing)
        maps = None if given else list(cracked_material.USED)
        folder = bpy.path.abspath(given) or os.path.join(engine.folder, f"maps-{runs.new_run()}")
        try:
            reply = yield from runs.bake(engine, order, size, maps, post, folder)
            yield
            images = map_images.load(reply["files"], thing.name, pack=not given)
        finally:
            if not given:
                shutil.rmtree(folder, ignore_errors=True)
        far = max(file["largest"] for file in reply["files"] if file["map"] == "distance")
        uv = order.mesh.uv_layers.active.name
        for trouble in cracked_material.wire(thing, uv, images, reply["sets"], far / 4):
            self.report({"WARNING"}, f"craze: {trouble}")
        for warning in reply["warnings"]:
            self.report({"WARNING"}, f"craze: {warning}")
        return f"{len(images)} images of {size} × {size} pixels"


CLASSES = [CRAZE_OT_bake]
