"""Craze: surface cracks as of mud, glaze, glass and paint, inside Blender.

The engine runs in a process of its own; this converts types and drives it.
"""

bl_info = {
    "name": "Craze",
    "author": "The craze authors",
    "version": (0, 0, 0),  # the build writes it
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Craze",
    "description": "Surface cracks as of mud, glaze, glass and paint",
    "category": "Mesh",
}

import bpy

from . import live, operators, panel, preferences, process, saving, settings, work


def register() -> None:
    bpy.utils.register_class(preferences.CrazePreferences)
    settings.register()
    operators.register()
    for cls in panel.CLASSES:
        bpy.utils.register_class(cls)
    live.register()
    work.register()
    saving.register()


def unregister() -> None:
    operators.unregister()  # first, as they may be at work
    live.unregister()
    process.stop()
    saving.unregister()
    work.unregister()
    for cls in reversed(panel.CLASSES):
        bpy.utils.unregister_class(cls)
    settings.unregister()
    bpy.utils.unregister_class(preferences.CrazePreferences)
