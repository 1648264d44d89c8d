"""bpy.ops.craze.grow(): the cracks open one after the other, as shape keys with keyed values."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np

from .. import cracked, layers, process, runs
from ..work import Problem, Steps
from .base import OfCracked

STAGES = 32  # as the command's --stages


class CRAZE_OT_grow(OfCracked, bpy.types.Operator):
    """Gives the cracked object shape keys from no crack to all of them, keyed from the current
    frame on. The attribute crack_growth says when each crack comes by, for shaders and nodes"""

    bl_idname = "craze.grow"
    bl_label = "Grow"

    frames: bpy.props.IntProperty(
        name="Frames", description="How long the growth takes", min=2, options={"SKIP_SAVE"}
    )

    def steps(self, context: Any) -> Steps:
        thing = context.active_object
        said = self.properties.is_property_set("frames")
        frames = self.frames if said else context.scene.craze.frames
        stages = min(frames, STAGES)
        times = [i / stages for i in range(stages)]
        post = cracked.post_of(thing)
        if post["gap"] == 0 and post["curl"] == 0:
            raise Problem("the cracks are shut, so nothing would move: give them a gap first")
        order = cracked.order_of(thing)
        made = yield from runs.grow(process.engine(), order, thing.data.name, times, post)
        cracked.replace_mesh(thing, made)
        _key(thing, made.grown, times, context.scene.frame_current, frames)
        return f"{stages} stages in {frames} frames"


def _key(thing: Any, grown: np.ndarray, times: list[float], start: int, frames: int) -> None:
    """A key per stage, 1 at its time and 0 at those beside it; at the end the shape is the basis,
    which is the finished one."""
    if thing.data.shape_keys is None:
        thing.shape_key_add(name="Basis", from_mix=False)
    step = frames * (times[1] - times[0])
    for places, time in zip(grown, times):
        key = thing.shape_key_add(name=f"growth {time:.3f}", from_mix=False)
        loose = layers.get(key.data, "co", np.float32, 3)
        loose[: len(places)] = places
        layers.put(key.data, "co", loose)
        middle = start + frames * time
        if time > 0:
            _keyed(key, 0.0, middle - step)
        _keyed(key, 1.0, middle)
        _keyed(key, 0.0, middle + step)
    action = thing.data.shape_keys.animation_data.action
    for curve in _curves(action):
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
