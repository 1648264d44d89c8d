"""Cracked objects: made of an object, and what they know of their run."""

from __future__ import annotations

import json
from typing import Any

import bpy
import numpy as np

from . import changes, mesh_in, mesh_out
from .runs import POST, Made, Order
from .work import Problem, Steps
from .world import hide, link, link_beside, unused


def is_cracked(thing: Any) -> bool:
    return thing is not None and thing.type == "MESH" and thing.craze.mesh is not None


def check_own(thing: Any) -> None:
    """Raises Problem where what is done to an object would be lost with the next reading of the file
    that it is linked from."""
    if thing.library is not None or thing.override_library is not None:
        raise Problem(f"{thing.name} belongs to another file: make it local, or crack it beside")


def group_names(thing: Any) -> list[str]:
    return [group.name for group in thing.vertex_groups]


def new_object(context: Any, scene: Any, thing: Any, made: Made, order: Order) -> Any:
    """A copy of an object that has the cracked mesh, beside it in its collections, active; the
    object itself, of `scene`, is hidden."""
    new = thing.copy()
    new.name = unused(f"{thing.name} cracked")
    new.hide_render = False  # it may have been hidden here before
    adopt(new, made, order)
    link_beside(context, scene, new, thing)
    hide(thing)
    return new


def beside(context: Any, scene: Any, thing: Any, meanwhile: bool) -> tuple[Any, str]:
    """A copy of an object that a user has changed, to have what was made of it, and what the user is
    told. One that was changed before is hidden as others are; one that was changed meanwhile is being
    worked on, and left as it is."""
    new = thing.copy()
    if not is_cracked(thing):
        new.name = unused(f"{thing.name} cracked")
    if meanwhile:
        link(scene, new, thing)
    else:
        link_beside(context, scene, new, thing)
        hide(thing)
    stays = "stays" if meanwhile else "stays, hidden"
    return new, f"craze: {thing.name} was changed by hand and {stays}; the cracks are in {new.name}"


def is_busy(thing: Any) -> bool:
    """Whether a mode of its own holds the object's mesh."""
    return thing.mode in {"EDIT", "SCULPT"}


def free(thing: Any) -> Steps:
    """Waits until an object can have another mesh."""
    while is_busy(thing):
        yield f"waiting until {thing.mode.capitalize()} Mode is left"


def adopt(thing: Any, made: Made, order: Order) -> None:
    """Gives an object the cracked mesh that was made of it, and what it was made of. Its modifiers
    are in the mesh."""
    for modifier in mesh_in.modifiers_to_apply(thing):
        thing.modifiers.remove(modifier)
    replace_mesh(thing, made)
    thing.craze.mesh = order.mesh
    thing.craze.groups = json.dumps(order.groups)


def replace_mesh(thing: Any, made: Made) -> None:
    """Gives an object a cracked mesh; one that it had before is removed."""
    old = thing.data if is_cracked(thing) else None
    if old is not None:
        keep_materials(old, made.mesh)
    thing.data = made.mesh
    if old is not None and old.users == 0:
        bpy.data.meshes.remove(old)
    thing.craze.run, thing.craze.digest, thing.craze.edited = made.run, made.digest, False
    thing.craze.stretch = json.dumps(made.stretch.tolist())
    thing.craze.report = json.dumps(made.report)
    thing.craze.recipe = json.dumps(made.report["recipe"])


def keep_materials(old: Any, new: Any) -> None:
    """Slots have what the user has given them since, baked cracks for one; walls have their own."""
    walls = new.materials.find(mesh_out.WALL)
    end = len(new.materials) if walls < 0 else walls
    for index, material in enumerate(old.materials):
        if material is not None and material.name == mesh_out.WALL:
            return
        if index < end:
            new.materials[index] = material
        elif walls < 0:
            new.materials.append(material)


def order_of(thing: Any) -> Order:
    """To make a cracked object's run again."""
    if not is_cracked(thing):
        raise Problem("the object was not cracked by craze, or not in this file")
    return Order(
        mesh=thing.craze.mesh,
        groups=json.loads(thing.craze.groups) if thing.craze.groups else group_names(thing),
        stretch=np.array(json.loads(thing.craze.stretch)),
        recipe=json.loads(thing.craze.recipe),
        run=thing.craze.run,
    )


def post_of(thing: Any) -> dict[str, Any]:
    """How its cracks are open."""
    post = json.loads(thing.craze.recipe)["post"]
    return {name: post[name] for name in POST}
