"""bpy.ops.craze.curves(): the cracks as a curve object."""

from __future__ import annotations

from typing import Any, Iterator

import bpy
import numpy as np

from .. import cracked, process, runs
from ..settings import GAP
from ..work import Problem, Steps
from ..world import link_beside, placed, remove
from .base import OfCracked

STEP = 2000  # edges looked at at a step


def chains(
    edges: np.ndarray, event: np.ndarray
) -> Iterator[tuple[list[int], list[int]] | None]:
    """(points, edges) of the lines that edges (e, 2) make, each from one end of a crack, `event`
    (e,), to the other, or around, in the order of the edges; None now and then, as it takes long."""
    at: dict[tuple[int, int], list[int]] = {}
    ends, events = edges.tolist(), event.tolist()
    for i, (a, b) in enumerate(ends):
        at.setdefault((events[i], a), []).append(i)
        at.setdefault((events[i], b), []).append(i)
        if i % STEP == STEP - 1:
            yield None
    used = [False] * len(ends)

    def walk(edge: int, point: int) -> tuple[list[int], list[int]]:
        points, along, number = [point], [], events[edge]
        while True:
            used[edge] = True
            along.append(edge)
            a, b = ends[edge]
            point = b if point == a else a
            points.append(point)
            here = at[number, point]
            more = [i for i in here if not used[i]]
            if len(here) != 2 or not more:
                return points, along
            edge = more[0]

    for closed in (False, True):  # what is left after the open lines goes around
        for i, (a, b) in enumerate(ends):
            for point in (a, b):
                if not used[i] and (closed or len(at[events[i], point]) != 2):
                    yield walk(i, point)
            if i % STEP == STEP - 1:
                yield None


def radii(points: list[int], along: list[int], width: np.ndarray) -> np.ndarray:
    """(n,) half the width at each point of a line: the mean of the edges beside it."""
    w = width[along]
    return np.concatenate([w[:1], (w[1:] + w[:-1]) / 2, w[-1:]])[: len(points)] / 2


class CRAZE_OT_curves(OfCracked, bpy.types.Operator):
    """Makes a curve object of the cracks: a line each, its radius half the crack's opening, times a
    bevel depth that makes it as wide as the crack is"""

    bl_idname = "craze.curves"
    bl_label = "Curves"

    def steps(self, context: Any) -> Steps:
        thing, scene = context.active_object, context.scene
        post = cracked.post_of(thing)
        arrays = yield from runs.lines(process.engine(), cracked.order_of(thing), post)
        if not len(arrays["edges"]):
            raise Problem("there are no cracks")
        plain, sheared = placed(thing.matrix_world)
        turn = np.array(sheared.to_3x3(), np.float32).T
        curve = bpy.data.curves.new(f"{thing.name} lines", "CURVE")
        done = False
        try:
            curve.dimensions = "3D"
            curve.bevel_depth = post["gap"] or GAP
            for line in chains(arrays["edges"], arrays["event"]):
                yield
                if line is None:
                    continue
                points, along = line
                spline = curve.splines.new("POLY")
                spline.points.add(len(points) - 1)
                places = np.ones((len(points), 4), np.float32)
                places[:, :3] = arrays["points"][points] @ turn
                spline.points.foreach_set("co", places.reshape(-1))
                spline.points.foreach_set(
                    "radius", radii(points, along, arrays["width"]).astype(np.float32)
                )
            new = bpy.data.objects.new(curve.name, curve)
            new.matrix_world = plain
            link_beside(context, scene, new, thing)
            done = True
        finally:
            if not done:
                remove([curve])
        return f"{len(curve.splines)} lines"


CLASSES = [CRAZE_OT_curves]
