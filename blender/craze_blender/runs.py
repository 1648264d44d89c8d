"""Runs of the engine on Blender's objects, as work in steps."""

from __future__ import annotations

import json
import uuid
from dataclasses import dataclass, field
from typing import Any

import bpy
import numpy as np

from . import changes, mesh_in, mesh_out, table, weights
from .process import Engine, arrays_in
from .work import Problem, Steps, asked, holding, last
from .world import remove

# What an opening takes; other keys crack anew.
POST = tuple(row["name"] for row in table.single() if row["section"] == "post")


def new_run() -> str:
    """A name for a run that no other has."""
    return uuid.uuid4().hex


@dataclass
class Order:
    """What is to be cracked, and how. `mesh` is a snapshot (mesh_in.py), `groups` the names of the
    object's vertex groups."""

    mesh: Any
    groups: list[str]
    stretch: np.ndarray
    recipe: Any  # as craze.crack takes it; the text of one where `is_text`
    is_text: bool = False
    settings: dict[str, Any] = field(default_factory=dict)
    run: str = field(default_factory=new_run)


@dataclass
class Made:
    """A cracked mesh. `report` is that of the run, as its cracks are open; `grown` has (n, 3) at each
    time that was asked for; `solids` (k, 4) of fragments that are closed: volume, and centre of
    mass."""

    mesh: Any
    digest: str  # of the mesh (changes.py)
    run: str
    stretch: np.ndarray
    report: dict[str, Any]
    warnings: list[str]
    grown: list[np.ndarray] = field(default_factory=list)
    solids: np.ndarray | None = None


def crack(engine: Engine, order: Order, name: str) -> Steps:
    """Made of cracking: the mesh is called `name` and opened as the recipe says."""
    if not len(order.mesh.polygons):
        raise Problem("the object has no faces to crack")
    arrays: dict[str, np.ndarray] = {}
    with holding(order.mesh):
        for key, values in mesh_in.arrays_of(order.mesh, order.stretch):
            arrays[key] = values
            yield
    read = yield from _groups(order)
    names = _named_by(order, arrays, dict(zip(order.groups, read)))
    yield
    reply = yield from asked(
        engine.send(
            "crack", arrays, run=order.run, names=names, recipe=order.recipe,
            is_text=order.is_text, settings=order.settings, post={},
        )
    )  # fmt: skip
    return (yield from _build(order, name, read, reply))


def open_again(engine: Engine, order: Order, name: str, post: dict[str, Any]) -> Steps:
    """Made of a run with its cracks open otherwise, or of solids where `post` has a thickness;
    cracked anew where the engine has lost it."""
    reply = yield from _of_run(engine, order, "open", post=post)
    return (yield from _build(order, name, (yield from _groups(order)), reply))


def grow(
    engine: Engine, order: Order, name: str, times: list[float], post: dict[str, Any]
) -> Steps:
    """As open_again(), with positions at times of the growth."""
    reply = yield from _of_run(engine, order, "grow", times=times, post=post)
    return (yield from _build(order, name, (yield from _groups(order)), reply))


def lines(engine: Engine, order: Order, post: dict[str, Any]) -> Steps:
    """The arrays of the cracks as lines, rough where `post` says so."""
    reply = yield from _of_run(engine, order, "lines", post=post)
    return (yield from last(arrays_in(reply)))


def bake(
    engine: Engine, order: Order, size: int, maps: list[str] | None, post: dict[str, Any], folder: str
) -> Steps:
    """Maps written to a folder, as worker/runs.py says it; `maps`: their names, None: all."""
    return (
        yield from _of_run(engine, order, "bake", size=size, maps=maps, post=post, folder=folder)
    )


@dataclass
class Tile:
    """Tileable maps: `files` as worker/runs.py says of bake(), and a preview (n, n, 3), sRGB."""

    files: list[dict[str, Any]]
    preview: np.ndarray
    warnings: list[str]


def texture(
    engine: Engine, recipe: Any, is_text: bool, settings: dict[str, Any], size: int, period: float,
    folder: str,
) -> Steps:  # fmt: skip
    """A Tile of a recipe, its maps written to a folder."""
    reply = yield from asked(
        engine.send(
            "texture", recipe=recipe, is_text=is_text, settings=settings, size=size, period=period,
            folder=folder,
        )
    )  # fmt: skip
    arrays = yield from last(arrays_in(reply))
    return Tile(reply["files"], arrays["preview"], reply["warnings"])


def _of_run(engine: Engine, order: Order, do: str, **fields: Any) -> Steps:
    """The reply to what is asked of a run, which is made anew where the engine has lost it."""
    reply = yield from asked(engine.send(do, run=order.run, **fields))
    if reply.get("lost"):
        made = yield from crack(engine, order, "lost")
        bpy.data.meshes.remove(made.mesh)
        reply = yield from asked(engine.send(do, run=order.run, **fields))
    return reply


def _groups(order: Order) -> Steps:
    with holding(order.mesh):
        return (yield from last(weights.read_groups(order.mesh, len(order.groups))))


def _build(order: Order, name: str, read: list[np.ndarray], reply: dict[str, Any]) -> Steps:
    arrays = yield from last(arrays_in(reply))
    grown = [arrays.pop(name) for name in sorted(arrays) if name.startswith("grown ")]
    solids = arrays.pop("solids", None)
    warnings = list(reply["warnings"])
    mesh, lost = yield from last(mesh_out.build(order.mesh, read, order.groups, name, arrays))
    if lost:
        warnings.append("not carried over: " + ", ".join(lost))
    digest = ""
    try:
        digest = yield from changes.digest(mesh, len(order.groups))
    finally:
        if not digest:
            remove([mesh])
    return Made(
        mesh, digest, order.run, order.stretch, reply["report"], warnings, grown, solids
    )


def _named_by(
    order: Order, arrays: dict[str, np.ndarray], groups: dict[str, np.ndarray]
) -> dict[str, Any]:
    """Adds the attributes and pictures that the recipe names."""
    text = order.recipe if isinstance(order.recipe, str) else _json(order.recipe)
    if isinstance(order.recipe, str) and order.recipe.lower().endswith((".toml", ".json")):
        try:
            with open(order.recipe, encoding="utf-8") as file:
                text = file.read()
        except (OSError, ValueError):
            pass  # the engine says it
    text += _json(order.settings)

    def named(name: str) -> bool:
        return _json(name) in text or f'"{name}"' in text or f"'{name}'" in text

    attributes = []
    for name in dict.fromkeys([*groups, *(a.name for a in order.mesh.attributes)]):
        values = mesh_in.attribute(order.mesh, groups, name) if named(name) else None
        if values is not None:
            arrays["attribute " + name] = values
            attributes.append(name)
    _check_attributes(order, attributes)
    pictures = [image for image in bpy.data.images if named(image.name)]
    for image in pictures:
        arrays["picture " + image.name] = mesh_in.picture(image)
    return {
        "attributes": attributes,
        "materials": mesh_in.material_names(order.mesh),
        "pictures": [image.name for image in pictures],
    }


def _check_attributes(order: Order, known: list[str]) -> None:
    """Raises Problem where the panel names one that is not there: the engine would list those alone
    that were named."""
    for row in table.single():
        if row["name"].endswith("attribute") and isinstance(order.recipe, dict):
            wanted = table.value_in(order.recipe, row["key"])
            if wanted and wanted not in known:
                groups = ", ".join(order.groups) or "none"
                raise Problem(f"what is cracked has no vertex group or attribute {wanted} "
                              f"({row['key']}); its vertex groups: {groups}")  # fmt: skip


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)
