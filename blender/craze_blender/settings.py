"""What the panel sets: a property per key of the table, kept in the scene; and what a cracked
object knows of how it came to be."""

from __future__ import annotations

from typing import Any

import bpy

from . import live, pictures, table
from .panel_recipe import LARGEST, is_vector, show, to_property
from .runs import POST

GAP = 0.1  # of a new scene: presets leave cracks shut, and those are not seen in a viewport

GROWTH = (
    ("KEYS", "Shape keys", "The engine's own stages, at most 32, with keyed values"),
    ("NODES", "Nodes", "A modifier with a keyed slider: each vertex moves at its time"),
)


def _first(row: dict[str, Any]) -> Any:
    """What a new scene's panel shows for a key."""
    if row["key"] == "post.gap":
        return GAP
    known = None if row["repeated"] else table.value_in(table.PRESETS[table.FIRST_PRESET], row["key"])
    return row["default"] if known is None else known


def _annotation(row: dict[str, Any], update: Any) -> Any:
    """The property of a key: type, range, default and help are the table's."""
    common: dict[str, Any] = {
        "name": row["name"].replace("_", " ").capitalize(),
        "description": row["help"],
        "update": update,
    }
    kind, default = row["type"], _first(row)
    limits = {}
    if row.get("minimum") is not None:
        limits["min"] = row["minimum"]
    if row.get("maximum") is not None:
        limits["max"] = row["maximum"]
    if kind == "boolean":
        return bpy.props.BoolProperty(default=default, **common)
    if kind == "choice":
        items = [(c, c.replace("-", " ").capitalize(), "") for c in row["choices"]]
        return bpy.props.EnumProperty(items=items, default=default, **common)
    if kind == "integer":
        whole = {k: int(min(v, LARGEST)) for k, v in limits.items()}
        return bpy.props.IntProperty(default=int(default), **whole, **common)
    if kind in {"real", "length"} and isinstance(default, (int, float)):
        if row["unit"] == "length":
            common.update(subtype="DISTANCE", unit="LENGTH")
        return bpy.props.FloatProperty(default=default, precision=3, **limits, **common)
    if is_vector(row):
        if kind == "vec3" and row["unit"] == "length":
            common.update(subtype="XYZ", unit="LENGTH")
        size = len(default)
        return bpy.props.FloatVectorProperty(default=default, size=size, **limits, **common)
    return bpy.props.StringProperty(default=to_property(row, default), **common)


def _preset_changed(settings: Any, _: Any) -> None:
    kept = {name: getattr(settings.keys, name) for name in ("post_gap", "post_wall", "post_curl")}
    kept["seed"] = settings.keys.seed
    show(settings, table.PRESETS[settings.preset])
    for name, value in kept.items():
        setattr(settings.keys, name, value)


def _key_changed(row: dict[str, Any]) -> Any:
    post = row["key"] in {f"post.{name}" for name in POST}
    other = table.row_of(row["instead_of"]) if post else None

    def update(keys: Any, context: Any) -> None:
        if other is not None and getattr(keys, table.property_name(row["key"])) != row["default"]:
            setattr(keys, table.property_name(other["key"]), other["default"])  # of two, the last
        live.wanted(context, "open" if post else "crack")

    return update


def _group(name: str, rows: list[tuple[str, dict[str, Any]]], more: dict[str, Any]) -> Any:
    annotations = {
        prop: _annotation(row, _key_changed(row)) for prop, row in rows
    }
    return type(name, (bpy.types.PropertyGroup,), {"__annotations__": {**annotations, **more}})


_SECTIONS = {
    section: _group(
        f"Craze{section.capitalize()}", [(row["name"], row) for row in rows], {}
    )
    for section, rows in table.repeated().items()
}
CrazeKeys = _group(
    "CrazeKeys",
    [(table.property_name(row["key"]), row) for row in table.single()],
    {s: bpy.props.CollectionProperty(type=group) for s, group in _SECTIONS.items()},
)


def _preset_property() -> Any:
    """Made when the add-on is enabled, as pictures are known by numbers that change."""
    return bpy.props.EnumProperty(
        name="Preset",
        description="What cracks: all keys of a recipe at once",
        items=[
            (name, name.replace("-", " ").capitalize(), table.DESCRIPTIONS.get(name, ""),
             pictures.icon(name), number)
            for number, name in enumerate(table.PRESETS)
        ],
        default=table.FIRST_PRESET,
        update=_preset_changed,
    )  # fmt: skip


class CrazeSettings(bpy.types.PropertyGroup):
    """The panel's settings, of a scene; and `preset`, see _preset_property()."""

    keys: bpy.props.PointerProperty(type=CrazeKeys)
    in_place: bpy.props.BoolProperty(
        name="In place",
        description="The object itself is cracked; otherwise a new one beside it, which is hidden",
    )
    live: bpy.props.BoolProperty(
        name="Update",
        description="A cracked object follows the sliders: how cracks are open at once, the rest in "
        "the background",
        default=True,
    )
    search: bpy.props.StringProperty(
        name="Search", description="Shows the keys that have this in their name or help"
    )
    thickness: bpy.props.FloatProperty(
        name="Thickness",
        description="How thick pieces are",
        subtype="DISTANCE",
        unit="LENGTH",
        min=0.0,
        default=0.02,
    )
    core: bpy.props.BoolProperty(
        name="Core",
        description="What is left inside a closed surface is one more piece, which stays",
    )
    frames: bpy.props.IntProperty(
        name="Frames", description="How long the growth takes", min=2, default=100
    )
    growth: bpy.props.EnumProperty(
        name="As", description="What opens the cracks", items=GROWTH
    )
    map_size: bpy.props.IntProperty(
        name="Size", description="Of baked images, pixels a side", min=1, max=8192, default=1024
    )
    map_folder: bpy.props.StringProperty(
        name="Folder",
        description="Where all maps are written, as .exr; empty: those that the material shows, "
        "packed into the .blend",
        subtype="DIR_PATH",
    )
    tile: bpy.props.FloatProperty(
        name="Tile",
        description="Side of the tile",
        subtype="DISTANCE",
        unit="LENGTH",
        min=1e-6,
        default=1.0,
    )
    library: bpy.props.StringProperty(
        name="Library",
        description="Folder of an asset library that gets the material; empty: it is an asset of "
        "this file",
        subtype="DIR_PATH",
    )


class CrazeObject(bpy.types.PropertyGroup):
    """How a cracked object came to be; empty for others."""

    mesh: bpy.props.PointerProperty(
        type=bpy.types.Mesh, description="The mesh that was cracked, modifiers applied"
    )
    recipe: bpy.props.StringProperty(description="The whole recipe, JSON")
    run: bpy.props.StringProperty(description="By which the engine knows the run")
    groups: bpy.props.StringProperty(description="Names of that mesh's vertex groups, JSON")
    digest: bpy.props.StringProperty(description="Of the mesh that was made (changes.py)")
    edited: bpy.props.BoolProperty(
        description="Somebody changed what was made: it does not follow the sliders"
    )
    stretch: bpy.props.StringProperty(
        description="From the object's axes to the shape that was cracked, 3 × 3, JSON"
    )
    report: bpy.props.StringProperty(description="The report of the run, JSON")


CLASSES = [*_SECTIONS.values(), CrazeKeys, CrazeSettings, CrazeObject]


def register() -> None:
    pictures.register()
    CrazeSettings.__annotations__["preset"] = _preset_property()
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Scene.craze = bpy.props.PointerProperty(type=CrazeSettings)
    bpy.types.Object.craze = bpy.props.PointerProperty(type=CrazeObject)


def unregister() -> None:
    del bpy.types.Object.craze
    del bpy.types.Scene.craze
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
    pictures.unregister()
