"""bpy.ops.craze.crack(): a cracked object of the active one."""

from __future__ import annotations

from typing import Any

import bpy

from .. import changes, cracked, mesh_in, panel_recipe, process, runs
from ..work import Steps
from ..world import remove
from .base import EngineOperator
from .recipe_options import WithRecipe


class CRAZE_OT_crack(WithRecipe, EngineOperator, bpy.types.Operator):
    """Cracks the active object: a new object beside it, or in place. A cracked object is cracked
    anew, from what it was. What is not said comes from the panel; a preset or recipe that is said
    stands for all of the panel's keys"""

    bl_idname = "craze.crack"
    bl_label = "Crack"

    in_place: bpy.props.BoolProperty(
        name="In place",
        description="The object itself is cracked; otherwise a new one beside it, which is hidden",
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Any) -> bool:
        thing = context.active_object
        if thing is not None and thing.type == "MESH" and context.mode == "OBJECT":
            return True
        cls.poll_message_set("craze: select a mesh, in Object Mode")
        return False

    def steps(self, context: Any) -> Steps:
        thing, scene = context.active_object, context.scene
        engine = process.engine()
        again, in_place = cracked.is_cracked(thing), self._in_place(scene.craze)
        chosen = len(context.selected_objects)
        if again or in_place:
            cracked.check_own(thing)
        if again:
            order = cracked.order_of(thing)
            order.run, order.stretch = runs.new_run(), mesh_in.stretch_of(thing.matrix_world)
        else:
            order = runs.Order(
                mesh=None,
                groups=cracked.group_names(thing),
                stretch=mesh_in.stretch_of(thing.matrix_world),
                recipe="",
            )
        to_engine = panel_recipe.to_engine(thing.matrix_world, order.stretch)
        order.recipe, order.is_text = self.given_recipe(context.scene.craze, to_engine)
        order.settings = self.given_settings(context.scene)
        if not again:
            order.mesh = mesh_in.snapshot(context, thing)
        meshes = [] if again else [order.mesh]  # to be removed where it does not get ready
        before = None
        if in_place and not again:
            before = changes.Before(thing, order.mesh)
        done = False
        try:
            name = thing.data.name if again else f"{thing.name} cracked"
            mine = again and (yield from changes.edited(thing))
            made = yield from runs.crack(engine, order, name)
            meshes.append(made.mesh)
            yield from cracked.free(thing)
            target, told = thing, ""
            if again and (mine or (yield from changes.edited(thing))):
                target, told = cracked.beside(context, scene, thing, not mine)
            elif before is not None and (yield from before.changed(thing)):
                target, told = cracked.beside(context, scene, thing, True)
            if again:
                cracked.replace_mesh(target, made)
            elif in_place:
                cracked.adopt(target, made, order)
            else:
                cracked.new_object(context, scene, thing, made, order)
            done = True
        finally:
            if before is not None:
                remove(before.kept())
            if not done:
                remove(meshes)
        if thing.library is not None:
            self.report({"WARNING"}, f"craze: {thing.name} belongs to another file: hidden, it is in "
                        "renders again when this one is opened anew")  # fmt: skip
        if told:
            self.report({"WARNING"}, told)
        for warning in dict.fromkeys(made.warnings + made.report["warnings"]):
            self.report({"WARNING"}, f"craze: {warning}")
        found = made.report["cracks"]
        alone = f"; of {chosen} selected objects the active one" if chosen > 1 else ""
        return f"{found['events']} cracks, {found['fragments']} fragments{alone}"

    def _in_place(self, panel: Any) -> bool:
        said = self.properties.is_property_set("in_place")
        return bool(self.in_place if said else panel.in_place)


CLASSES = [CRAZE_OT_crack]
