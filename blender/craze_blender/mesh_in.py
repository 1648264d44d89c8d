"""A Blender object as what the engine's process takes."""

from __future__ import annotations

from typing import Any, Iterator

import bpy
import numpy as np

from . import layers
from .work import Problem

# Modifiers that go on working on the cracked mesh; all others are applied before.
KEPT_MODIFIERS = {"ARMATURE"}
SNAPSHOT = ".craze "  # begins its name; a dot: not in Blender's lists
LEAST_SCALE = 1e-4  # of an axis, over the largest: less would be lost in six digits


def modifiers_to_apply(thing: Any) -> list[Any]:
    return [m for m in thing.modifiers if m.show_viewport and m.type not in KEPT_MODIFIERS]


def snapshot(context: Any, thing: Any) -> Any:
    """A new mesh: that of the object with its modifiers applied, armatures excepted. Shape keys
    stay keys where no modifier is applied; otherwise they are in the shape."""
    if thing.mode == "EDIT":
        thing.update_from_editmode()
    if not modifiers_to_apply(thing):
        made = thing.data.copy()
    else:
        made = _evaluated(context, thing)
    made.name = f"{SNAPSHOT}{thing.name}"
    return made


def _evaluated(context: Any, thing: Any) -> Any:
    double = thing.copy()
    try:
        for modifier in list(double.modifiers):
            if modifier.type in KEPT_MODIFIERS:
                double.modifiers.remove(modifier)
        double.hide_viewport = False  # else its modifiers would not be seen
        context.scene.collection.objects.link(double)
        graph = context.evaluated_depsgraph_get()
        graph.update()
        return bpy.data.meshes.new_from_object(
            double.evaluated_get(graph), preserve_all_data_layers=True, depsgraph=graph
        )
    finally:
        bpy.data.objects.remove(double)


def stretch_of(matrix: Any) -> np.ndarray:
    """(3, 3) symmetric: what an object's matrix does to shapes, turning and moving left out, to
    six digits: more a matrix of float32 does not hold, so a turned object cracks as one that is
    not. A mirrored object cracks as it is modelled. Raises Problem where it leaves no volume: there
    is no way back from such a shape.
    """
    linear = np.array(matrix.to_3x3(), np.float64)
    _, size, right = np.linalg.svd(linear)
    stretch = right.T @ np.diag(size) @ right
    largest = float(size.max())
    if not np.isfinite(size).all() or size.min() < LEAST_SCALE * largest or largest == 0:
        raise Problem("the object is scaled to nothing, or nearly so, along an axis")
    digits = 5 - int(np.floor(np.log10(largest)))
    rounded = np.round(stretch, digits)
    return (rounded + rounded.T) / 2


def arrays_of(mesh: Any, stretch: np.ndarray) -> Iterator[tuple[str, np.ndarray]]:
    """The arrays that worker/runs.py takes, attributes left out, one at a step."""
    yield "stretch", stretch
    mesh.calc_loop_triangles()
    for name, collection, of, dtype, columns in (
        ("vertices", mesh.vertices, "co", np.float32, 3),
        ("edges", mesh.edges, "vertices", np.int32, 2),
        ("loop_vertex", mesh.loops, "vertex_index", np.int32, 1),
        ("loop_start", mesh.polygons, "loop_start", np.int32, 1),
        ("loop_total", mesh.polygons, "loop_total", np.int32, 1),
        ("triangles", mesh.loop_triangles, "loops", np.int32, 3),
        ("triangle_polygon", mesh.loop_triangles, "polygon_index", np.int32, 1),
        ("material", mesh.polygons, "material_index", np.int32, 1),
    ):
        yield name, layers.get(collection, of, dtype, columns)
    if mesh.uv_layers.active is not None:
        yield "uv", layers.get(mesh.uv_layers.active.data, "uv", np.float32, 2)


def material_names(mesh: Any) -> list[str]:
    """Of each slot; an empty one is a material without a name of its own."""
    return [m.name if m is not None else f"slot {i}" for i, m in enumerate(mesh.materials)]


def attribute(mesh: Any, groups: dict[str, np.ndarray], name: str) -> np.ndarray | None:
    """(n,) per vertex: a vertex group, or an attribute; of a colour the luminance, of corners and
    faces the mean at each vertex. None: there is no such thing."""
    if name in groups:
        return np.nan_to_num(groups[name])
    layer = mesh.attributes.get(name)
    if layer is None or layer.data_type not in {
        "FLOAT", "INT", "INT8", "BOOLEAN", "FLOAT_COLOR", "BYTE_COLOR",
    }:  # fmt: skip
        return None
    if layer.data_type.endswith("COLOR"):
        values = layers.get(layer.data, "color", np.float32, 4)[:, :3] @ (0.2126, 0.7152, 0.0722)
    else:
        dtype = bool if layer.data_type == "BOOLEAN" else np.float32
        dtype = np.int32 if layer.data_type.startswith("INT") else dtype
        values = layers.get(layer.data, "value", dtype).astype(np.float64)
    if layer.domain == "POINT":
        return np.asarray(values)
    at = layers.get(mesh.loops, "vertex_index", np.int32)
    if layer.domain == "FACE":
        values = np.repeat(values, layers.get(mesh.polygons, "loop_total", np.int32))
    elif layer.domain != "CORNER":
        return None
    count = len(mesh.vertices)
    total = np.bincount(at, weights=values, minlength=count)
    return np.asarray(total / np.maximum(np.bincount(at, minlength=count), 1))


def picture(image: Any) -> np.ndarray:
    """(height, width, channels) float32, row 0 on top."""
    width, height = image.size
    pixels = np.empty(width * height * image.channels, np.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(height, width, image.channels)[::-1]
