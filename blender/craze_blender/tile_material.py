"""Materials of tileable textures, for any object with UVs."""

from __future__ import annotations

from typing import Any

import bpy

from .cracked_material import principled
from .nodes import add, new_material, socket

USED = ("base_color", "normal", "height", "occlusion", "roughness")  # the maps that it shows
PLACE = "Craze Tile"  # the node that says how often the tile repeats


def new(name: str, images: dict[str, Any]) -> Any:
    """A material of images by their maps, USED: a tile is a unit of the active UV map. Heights are a
    displacement, which Blender takes for a bump, and the normals stand for, unless the material's
    settings say otherwise."""
    material = new_material(name)
    tree = material.node_tree
    shader = principled(tree)
    link = tree.links.new
    place = add(tree, "ShaderNodeMapping", (-1100, 0))
    place.name = place.label = PLACE
    link(add(tree, "ShaderNodeTexCoord", (-1300, 0)).outputs["UV"], place.inputs["Vector"])
    shown = {}
    for row, map_name in enumerate(USED):
        node = add(tree, "ShaderNodeTexImage", (-850, 500 - 300 * row), image=images[map_name])
        node.name = node.label = f"Craze {map_name}"
        link(place.outputs["Vector"], node.inputs["Vector"])
        shown[map_name] = node.outputs["Color"]

    shade = add(
        tree, "ShaderNodeMix", (-450, 300), data_type="RGBA", blend_type="MULTIPLY", label="Occlusion"
    )
    socket(shade.inputs, "Factor_Float").default_value = 1.0
    link(shown["base_color"], socket(shade.inputs, "A_Color"))
    link(shown["occlusion"], socket(shade.inputs, "B_Color"))
    link(socket(shade.outputs, "Result_Color"), shader.inputs["Base Color"])
    link(shown["roughness"], shader.inputs["Roughness"])
    normal = add(tree, "ShaderNodeNormalMap", (-450, 0))
    link(shown["normal"], normal.inputs["Color"])
    link(normal.outputs["Normal"], shader.inputs["Normal"])
    height = add(tree, "ShaderNodeDisplacement", (0, -300))
    height.inputs["Midlevel"].default_value, height.inputs["Scale"].default_value = 0.0, 1.0
    link(shown["height"], height.inputs["Height"])
    output = tree.get_output_node("ALL")
    link(height.outputs["Displacement"], output.inputs["Displacement"])
    return material
