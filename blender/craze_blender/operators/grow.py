"""bpy.ops.craze.grow(): the cracks open one after the other, as shape keys with keyed values or as
nodes with a keyed slider."""

from __future__ import annotations

import json
from typing import Any, Iterator

import bpy
import numpy as np

from .. import changes, cracked, growth_nodes, layers, process, runs, settings, table
from ..weights import own_action
from ..work import Problem, Steps
from ..world import remove
from .base import OfCracked

STAGES = 32  # as the command's --stages


class CRAZE_OT_grow(OfCracked, bpy.types.Operator):
    """Lets the cracks of the object open one after the other, keyed from the current frame on, as
    shape keys or by nodes with a slider. The attribute crack_growth says when each crack comes by"""

    bl_idname = "craze.grow"
    bl_label = "Grow"

    frames: bpy.props.IntProperty(
        name="Frames", description="How long the growth takes", min=2, options={"SKIP_SAVE"}
    )
    method: bpy.props.EnumProperty(
        name="As", description="What opens the cracks", items=settings.GROWTH, options={"SKIP_SAVE"}
    )

    gap: bpy.props.FloatProperty(
        name="Gap",
        description="How far the cracks open, times their displacement; 0: as they are open",
        min=0.0,
        options={"SKIP_SAVE"},
    )

    def steps(self, context: Any) -> Steps:
        thing = context.active_object
        cracked.check_own(thing)
        said = self.properties.is_property_set
        frames = self.frames if said("frames") else context.scene.craze.frames
        method = self.method if said("method") else context.scene.craze.growth
        stages = min(frames, STAGES) if method == "KEYS" else 1
        times = [i / stages for i in range(stages)]
        post = cracked.post_of(thing)
        if not json.loads(thing.craze.report)["cracks"]["events"]:
            raise Problem("there are no cracks to grow")
        if self.gap > 0:
            post.update(gap=table.as_typed(self.gap), gap_width=0)
        if not post["gap"] and not post["gap_width"] and not post["curl"]:
            raise Problem("the cracks are shut, so nothing would move: raise Gap in the panel first, "
                          "or say grow(gap=0.1)")  # fmt: skip
        order = cracked.order_of(thing)
        mine = yield from changes.edited(thing)
        made = yield from runs.grow(process.engine(), order, thing.data.name, times, post)
        start = context.scene.frame_current
        done = False
        try:
            if method == "KEYS":
                yield from _key(made, times, start, frames)
            else:
                _opening(made)
            made.digest = yield from changes.digest(made.mesh, len(order.groups))
            yield from cracked.free(thing)
            target = thing
            if mine or (yield from changes.edited(thing)):
                target, told = cracked.beside(context, context.scene, thing, not mine)
                self.report({"WARNING"}, told)
            cracked.replace_mesh(target, made)
            done = True
        finally:
            if not done:
                remove([made.mesh])
        if method == "KEYS":
            return f"{stages} stages in {frames} frames"
        _slide(target, start, frames)
        return f"{frames} frames"


def _key(made: runs.Made, times: list[float], start: int, frames: int) -> Iterator[None]:
    """A key per stage, 1 at its time and 0 at those beside it; at the end the shape is the basis,
    which is the finished one."""
    double = bpy.data.objects.new(made.mesh.name, made.mesh)  # keys are made through an object
    try:
        if made.mesh.shape_keys is None:
            double.shape_key_add(name="Basis", from_mix=False)
        step = frames * (times[1] - times[0])
        for places, time in zip(made.grown, times):
            yield
            key = double.shape_key_add(name=f"growth {time:.3f}", from_mix=False)
            loose = layers.get(key.data, "co", np.float32, 3)
            loose[: len(places)] = places
            layers.put(key.data, "co", loose)
            middle = start + frames * time
            if time > 0:
                _keyed(key, 0.0, middle - step)
            _keyed(key, 1.0, middle)
            _keyed(key, 0.0, middle + step)
        for curve in _curves(made.mesh.shape_keys.animation_data.action):
            if curve.data_path.startswith('key_blocks["growth '):
                _straight(curve)
    finally:
        remove([double])


def _opening(made: runs.Made) -> None:
    """How far each vertex has come from where it was without cracks, as an attribute."""
    shut, co = made.grown[0], layers.get(made.mesh.vertices, "co", np.float32, 3)
    opening = np.zeros_like(co)
    opening[: len(shut)] = co[: len(shut)] - shut
    layers.set_attribute(made.mesh, growth_nodes.MOVE, "POINT", opening)


def _slide(thing: Any, start: int, frames: int) -> None:
    """The modifier, its slider keyed from 0 to 1; before those that the object has."""
    modifier = thing.modifiers.get(growth_nodes.GROUP)
    if modifier is None:
        modifier = thing.modifiers.new(growth_nodes.GROUP, "NODES")
    if thing.modifiers[0] != modifier:
        with bpy.context.temp_override(object=thing):
            bpy.ops.object.modifier_move_to_index(modifier=modifier.name, index=0)
    modifier.node_group = growth_nodes.growth_group()
    slider = growth_nodes.slider_of(modifier.node_group)
    path = f'modifiers["{modifier.name}"]["{slider}"]'
    thing.animation_data_create()
    own_action(thing.animation_data)
    if thing.animation_data.action is not None:
        for curve in _curves(thing.animation_data.action):
            if curve.data_path == path:
                curve.keyframe_points.clear()
    for value, frame in ((0.0, start), (1.0, start + frames)):
        modifier[slider] = value
        thing.keyframe_insert(path, frame=frame)
    for curve in _curves(thing.animation_data.action):
        if curve.data_path == path:
            _straight(curve)


def _straight(curve: Any) -> None:
    for point in curve.keyframe_points:
        point.interpolation = "LINEAR"


def _keyed(key: Any, value: float, frame: float) -> None:
    key.value = value
    key.keyframe_insert("value", frame=frame)


def _curves(action: Any) -> list[Any]:
    """Its curves: of the one slot from 5.0 on, of the action itself before."""
    if hasattr(action, "fcurves"):
        return list(action.fcurves)
    return [c for layer in action.layers for s in layer.strips for bag in s.channelbags
            for c in bag.fcurves]  # fmt: skip


CLASSES = [CRAZE_OT_grow]
