"""Where the engine is, if it did not come with the add-on."""

from __future__ import annotations

import bpy


class CrazePreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    package: bpy.props.StringProperty(
        name="Engine",
        description="The folder that holds the Python package craze; empty: the one that came with "
        "the add-on, or an installed one",
        subtype="DIR_PATH",
    )

    def draw(self, _: bpy.types.Context) -> None:
        self.layout.prop(self, "package")


def package_folder() -> str:
    """As the user set it; "" where the add-on runs without being enabled, as from a script."""
    addon = bpy.context.preferences.addons.get(__package__)
    return "" if addon is None else bpy.path.abspath(addon.preferences.package)
