"""A file that is saved while the engine runs. Blender leaves meshes that nobody uses out of a file,
but not their shape keys, and complains of those when the file is opened: so a snapshot with shape keys
is saved too, and is gone when the file is opened."""

from __future__ import annotations

from typing import Any

import bpy
from bpy.app.handlers import persistent

from .mesh_in import SNAPSHOT
from .world import remove


class _Holders:
    """Objects that use the snapshots while a file is written."""

    names: list[str] = []


def _snapshots() -> list[Any]:
    return [m for m in bpy.data.meshes if m.users == 0 and m.name.startswith(SNAPSHOT)]


@persistent
def _before(*_: Any) -> None:
    for mesh in _snapshots():
        if mesh.shape_keys is not None:
            _Holders.names.append(bpy.data.objects.new(mesh.name, mesh).name)


@persistent
def _after(*_: Any) -> None:
    known = [bpy.data.objects.get(name) for name in _Holders.names]
    _Holders.names = []
    remove([holder for holder in known if holder is not None])


@persistent
def _opened(*_: Any) -> None:
    remove(_snapshots())


def register() -> None:
    bpy.app.handlers.save_pre.append(_before)
    bpy.app.handlers.save_post.append(_after)
    bpy.app.handlers.load_post.append(_opened)


def unregister() -> None:
    bpy.app.handlers.save_pre.remove(_before)
    bpy.app.handlers.save_post.remove(_after)
    bpy.app.handlers.load_post.remove(_opened)
