"""What a Blender mesh carries besides its shape: read into arrays, mixed by weights, written.

Blender 3.4 keeps creases, bevel weights and UV maps beside its attributes, 4.x among them; both are
read here as what there is (docs/blender.md has the table of differences).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Generator, Iterator

import numpy as np

ROWS = 1 << 15  # elements that are mixed at a step

# data_type: (property, dtype, columns, mixed by weights; others are taken from the nearest).
_TYPES: dict[str, tuple[str, Any, int, bool]] = {
    "FLOAT": ("value", np.float32, 1, True),
    "INT": ("value", np.int32, 1, False),
    "INT8": ("value", np.int32, 1, False),
    "BOOLEAN": ("value", bool, 1, False),
    "FLOAT_VECTOR": ("vector", np.float32, 3, True),
    "FLOAT2": ("vector", np.float32, 2, True),
    "FLOAT_COLOR": ("color", np.float32, 4, True),
    "BYTE_COLOR": ("color_srgb", np.float32, 4, True),  # as it is stored, and as Blender mixes it
    "QUATERNION": ("value", np.float32, 4, False),
    "INT32_2D": ("value", np.int32, 2, False),
    "FLOAT4X4": ("value", np.float32, 16, False),
    "STRING": ("value", object, 1, False),
}
# (collection, property, dtype, domain, mixed): what elements have themselves, in some Blender.
_OWN: tuple[tuple[str, str, Any, str, bool], ...] = (
    ("vertices", "bevel_weight", np.float32, "POINT", True),
    ("vertices", "hide", bool, "POINT", False),
    ("edges", "use_seam", bool, "EDGE", False),
    ("edges", "use_edge_sharp", bool, "EDGE", False),
    ("edges", "use_freestyle_mark", bool, "EDGE", False),
    ("edges", "crease", np.float32, "EDGE", True),
    ("edges", "bevel_weight", np.float32, "EDGE", True),
    ("edges", "hide", bool, "EDGE", False),
    ("polygons", "use_smooth", bool, "FACE", False),
    ("polygons", "use_freestyle_mark", bool, "FACE", False),
    ("polygons", "hide", bool, "FACE", False),
    ("polygons", "material_index", np.int32, "FACE", False),
)
# Attributes that are the shape, or that _OWN reads.
_SHAPE = {
    "position", "material_index", "sharp_edge", "sharp_face", "uv_seam", "freestyle_edge",
    "freestyle_face", "custom_normal",
}  # fmt: skip


@dataclass(frozen=True)
class Maps:
    """How elements of a domain come from those of the source: indices (n, k) and weights (n, k);
    −1: from none."""

    index: np.ndarray
    weight: np.ndarray

    @cached_property
    def nearest(self) -> np.ndarray:
        """(n,): the index of the largest weight."""
        at = self.weight.argmax(axis=1)[:, None]
        return np.take_along_axis(self.index, at, axis=1)[:, 0]

    @cached_property
    def whole(self) -> np.ndarray:
        """(n,) bool: one weight is 1, the others are 0."""
        return np.asarray(self.weight.max(axis=1) == 1.0)

    @cached_property
    def _between(self) -> np.ndarray:
        return np.flatnonzero(~self.whole)

    @cached_property
    def parts(self) -> list[Maps]:
        """The same, ROWS elements each."""
        begins = range(0, len(self.index), ROWS)
        return [Maps(self.index[i : i + ROWS], self.weight[i : i + ROWS]) for i in begins]

    def mixed(self, values: np.ndarray) -> np.ndarray:
        """(n, c) of (s, c). A weight of 1 copies, to the bit."""
        made = values[self.nearest]
        rows = self._between
        if len(rows):
            weight, index = self.weight[rows], self.index[rows]
            total = sum(weight[:, i, None] * values[index[:, i]] for i in range(index.shape[1]))
            made[rows] = total
        made[self.nearest < 0] = 0
        return made


def maps(arrays: dict[str, np.ndarray]) -> dict[str, Maps]:
    """Of each domain, from what the engine's process gave."""

    def single(index: np.ndarray) -> Maps:
        return Maps(index[:, None], np.ones((len(index), 1)))

    return {
        "POINT": Maps(arrays["point_source"], arrays["point_weight"]),
        "CORNER": Maps(arrays["corner_source"], arrays["corner_weight"]),
        "FACE": single(arrays["face_source"]),
        "EDGE": single(arrays["edge_source"]),
    }


def _fast(collection: Any, name: str, dtype: Any) -> Any:
    """Blender copies whole numbers at once where they are signed as its own are, else one by one."""
    if dtype is np.int32 and len(collection):
        if collection[0].bl_rna.properties[name].subtype == "UNSIGNED":
            return np.uint32
    return dtype


def get(collection: Any, name: str, dtype: Any, columns: int = 1) -> np.ndarray:
    """(n, columns) of a property of a collection; (n,) for one column."""
    if dtype is object:
        return np.array([getattr(item, name) for item in collection], object)
    values = np.empty(len(collection) * columns, _fast(collection, name, dtype))
    collection.foreach_get(name, values)
    values = values.view(dtype)
    return values.reshape(-1, columns) if columns > 1 else values


def put(collection: Any, name: str, values: np.ndarray) -> None:
    if values.dtype == object:
        for item, value in zip(collection, values):
            setattr(item, name, value)
    else:
        flat = np.ascontiguousarray(values).reshape(-1)
        collection.foreach_set(name, flat.view(_fast(collection, name, flat.dtype.type)))


def taken(
    of: Maps, values: np.ndarray, mixed: bool = True
) -> Generator[None, None, np.ndarray]:
    """Values of the source, (s,) or (s, c), for each element: mixed by the weights or those of the
    nearest. Yields after each of the parts."""
    rows = values.reshape(len(values), -1)
    made = np.empty((len(of.index), rows.shape[1]), rows.dtype)
    begin = 0
    for part in of.parts:
        end = begin + len(part.index)
        if mixed:
            made[begin:end] = part.mixed(rows)
        else:
            made[begin:end] = rows[part.nearest]
            made[begin:end][part.nearest < 0] = b"" if rows.dtype == object else 0
        begin = end
        yield
    return made.reshape(-1, *values.shape[1:])


def carry(source: Any, target: Any, of: dict[str, Maps]) -> Iterator[str | None]:
    """Carries all layers but weights and shape keys from one mesh to another, in steps; yields
    names of what cannot be."""
    uv_names = {layer.name for layer in source.uv_layers}
    for layer in list(source.uv_layers):
        values = yield from taken(of["CORNER"], get(layer.data, "uv", np.float32, 2))
        new = target.uv_layers.new(name=layer.name, do_init=False)
        put(new.data, "uv", values)
        new.active_render = layer.active_render
        yield
    if source.uv_layers.active is not None and target.uv_layers:
        target.uv_layers.active_index = source.uv_layers.active_index
    for attribute in list(source.attributes):
        name = attribute.name
        if name.startswith(".") or name in _SHAPE or name in uv_names:
            continue
        if attribute.data_type not in _TYPES or attribute.domain not in of:
            yield name
            continue
        property_, dtype, columns, mixed = _TYPES[attribute.data_type]
        values = get(attribute.data, property_, dtype, columns)
        yield
        values = yield from taken(of[attribute.domain], values, mixed)
        new = target.attributes.get(name) or target.attributes.new(
            name, attribute.data_type, attribute.domain
        )
        put(new.data, property_, values)
        yield
    _carry_active_colour(source, target)
    for collection, name, dtype, domain, mixed in _OWN:
        items = getattr(source, collection)
        if len(items) == 0 or not hasattr(items[0], name):
            continue
        values = get(items, name, dtype)
        yield
        if values.any():
            put(getattr(target, collection), name, (yield from taken(of[domain], values, mixed)))
            yield
    yield from _carry_creases(source, target, of["POINT"])


def all_of(mesh: Any) -> Iterator[tuple[str, np.ndarray]]:
    """Shape, layers and shape keys of a mesh, a name and an array at a step; what is hidden or
    selected does not count, and weights are not there (weights.py)."""
    for collection, name, dtype, columns in (
        ("vertices", "co", np.float32, 3),
        ("edges", "vertices", np.int32, 2),
        ("loops", "vertex_index", np.int32, 1),
        ("polygons", "loop_start", np.int32, 1),
    ):
        yield name, get(getattr(mesh, collection), name, dtype, columns)
    for layer in list(mesh.uv_layers):
        yield layer.name, get(layer.data, "uv", np.float32, 2)
    uv_names = {layer.name for layer in mesh.uv_layers}
    for attribute in list(mesh.attributes):
        name = attribute.name
        if name.startswith(".") or name in _SHAPE or name in uv_names:
            continue
        if attribute.data_type in _TYPES:
            property_, dtype, columns, _ = _TYPES[attribute.data_type]
            values = get(attribute.data, property_, dtype, columns)
            yield name, values if dtype is not object else np.array(values, np.bytes_)
    for collection, name, dtype, _, _ in _OWN:
        items = getattr(mesh, collection)
        if name != "hide" and len(items) and hasattr(items[0], name):
            yield name, get(items, name, dtype)
    if mesh.shape_keys is not None:
        for block in mesh.shape_keys.key_blocks:
            yield block.name, get(block.data, "co", np.float32, 3)


def _carry_active_colour(source: Any, target: Any) -> None:
    active = source.color_attributes.active_color
    if active is not None and active.name in target.color_attributes:
        target.color_attributes.active_color = target.color_attributes[active.name]
    render = source.color_attributes.render_color_index
    if 0 <= render < len(target.color_attributes):
        target.color_attributes.render_color_index = render


def _carry_creases(source: Any, target: Any, of: Maps) -> Iterator[str | None]:
    """Creases of vertices where they are no attribute (before 4.0); they can only be made by an
    operator there, so they are carried where the target has them."""
    creases = getattr(source, "vertex_creases", ())
    if len(creases) and len(creases[0].data):
        values = get(creases[0].data, "value", np.float32)
        if values.any():
            if len(target.vertex_creases):
                put(target.vertex_creases[0].data, "value", (yield from taken(of, values)))
            else:
                yield "crease of vertices"


def custom_normals(source: Any) -> np.ndarray | None:
    """(l, 3) float32 per corner where somebody set them."""
    if not source.has_custom_normals:
        return None
    if hasattr(source, "corner_normals"):  # 4.1 and later
        return get(source.corner_normals, "vector", np.float32, 3)
    source.calc_normals_split()
    return get(source.loops, "normal", np.float32, 3)


def set_custom_normals(target: Any, normals: np.ndarray) -> None:
    """Corners of zero length take the normal that they would have without."""
    target.normals_split_custom_set(normals)
    if hasattr(target, "use_auto_smooth"):
        target.use_auto_smooth = True


def set_attribute(mesh: Any, name: str, domain: str, values: np.ndarray) -> None:
    """An attribute of floats, whole numbers or vectors; one of that name is replaced."""
    old = mesh.attributes.get(name)
    if old is not None:
        mesh.attributes.remove(old)
    kind = "FLOAT_VECTOR" if values.ndim == 2 else "INT" if values.dtype == np.int32 else "FLOAT"
    new = mesh.attributes.new(name, kind, domain)
    put(new.data, "vector" if values.ndim == 2 else "value", values)
