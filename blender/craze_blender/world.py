"""Where objects are, who sees them, and how what did not get ready goes."""

from __future__ import annotations

from typing import Any, Iterable

import bpy
from mathutils import Matrix

from .work import is_there

NEARLY = 1e-5  # of the largest number of a matrix
LONGEST = 63  # bytes of a name


def placed(matrix: Any) -> tuple[Any, Any]:
    """Two matrices whose product is that of an object: what an object can have by itself, place,
    turn and scale, and the rest, which its mesh has to have; that is none unless it is sheared, as
    by a parent that is scaled."""
    plain = Matrix.LocRotScale(*matrix.decompose())
    largest = max(abs(x) for row in matrix for x in row)
    apart = max(abs(a - b) for rows in zip(plain, matrix) for a, b in zip(*rows))
    if apart <= NEARLY * largest:
        return matrix, Matrix.Identity(4)
    return plain, plain.inverted_safe() @ matrix


def unused(name: str) -> str:
    """A name that no object has: Blender would rename the one that has it."""
    found, count = name, 0
    while _cut(found) in bpy.data.objects:
        count += 1
        end = f".{count:03}"
        found = _cut(name, LONGEST - len(end)) + end
    return _cut(found)


def _cut(name: str, size: int = LONGEST) -> str:
    return name.encode()[:size].decode(errors="ignore")


def link(scene: Any, new: Any, thing: Any) -> None:
    """Links an object where another one is, those collections left out that belong to other files,
    and to the scene itself where it is in none then."""
    for collection in thing.users_collection:
        if collection.library is None and collection.override_library is None:
            collection.objects.link(new)
    if scene not in new.users_scene:
        scene.collection.objects.link(new)


def link_beside(context: Any, scene: Any, new: Any, thing: Any) -> None:
    """As link(); selected alone and active where that is seen and the user has not gone on to
    something else."""
    link(scene, new, thing)
    if context.mode != "OBJECT" or context.active_object != thing:
        return
    old = context.selected_objects
    try:
        new.select_set(True)
    except RuntimeError:  # another scene is seen by now
        return
    for other in old:
        other.select_set(False)
    context.view_layer.objects.active = new


def hide(thing: Any) -> None:
    """From view and from renders."""
    try:
        thing.hide_set(True)
    except RuntimeError:  # another scene is seen by now
        pass
    thing.hide_render = True


def remove(things: Iterable[Any]) -> None:
    """Removes what is still there of data-blocks that did not get ready: an undo, another file or a
    user may have removed some before, and Blender ends where it is told to remove one twice. Shape
    keys go with their meshes, which Blender forgets here."""
    there = [thing for thing in things if is_there(thing)]
    keys = [getattr(thing, "shape_keys", None) for thing in there]
    bpy.data.batch_remove([*there, *(key for key in keys if key is not None)])
