"""The shader node group "Craze Cracks": what baked maps do to a surface."""

from __future__ import annotations

from typing import Any

import bpy

from .mesh_out import WALL_COLOUR
from .nodes import add, new_socket, socket

GROUP = "Craze Cracks"
DUST = (0.12, 0.09, 0.06, 1.0)

# (name, kind, default, range). The first four are for pictures and for what the surface has without
# cracks, the others for the user.
_INPUTS: tuple[tuple[str, str, Any, tuple[float, float] | None], ...] = (
    ("Color", "Color", (0.8, 0.8, 0.8, 1.0), None),
    ("Normal", "Vector", None, None),
    ("Mask", "Float", 0.0, None),
    ("Height", "Float", 0.0, None),
    ("Distance", "Float", 0.0, None),
    ("Crack Color", "Color", WALL_COLOUR, None),
    ("Crack", "Float", 1.0, (0.0, 1.0)),
    ("Depth", "Float", 1.0, (0.0, 10.0)),
    ("Stain Color", "Color", DUST, None),
    ("Stain", "Float", 0.5, (0.0, 1.0)),
    ("Stain Reach", "Float", 0.1, (0.0, 1e6)),
)
_OUTPUTS = (("Color", "Color"), ("Normal", "Vector"), ("Height", "Float"))


def crack_group() -> Any:
    """The group of this file, made where there is none: the mask is of the crack's colour, the
    surface beside it stained up to a reach, and the height times the depth is a bump."""
    known = bpy.data.node_groups.get(GROUP)
    if known is not None and known.bl_idname == "ShaderNodeTree":
        return known
    tree = bpy.data.node_groups.new(GROUP, "ShaderNodeTree")
    for name, kind, default, limits in _INPUTS:
        given = new_socket(tree, "INPUT", name, f"NodeSocket{kind}")
        if default is None:
            given.hide_value = True
        else:
            given.default_value = default
        if limits is not None:
            given.min_value, given.max_value = limits
    for name, kind in _OUTPUTS:
        new_socket(tree, "OUTPUT", name, f"NodeSocket{kind}")
    _fill(tree)
    return tree


def _fill(tree: Any) -> None:
    given = add(tree, "NodeGroupInput", (-800, 0)).outputs
    made = add(tree, "NodeGroupOutput", (600, 0)).inputs
    link = tree.links.new

    def mixed(place: tuple[float, float], factor: Any, first: Any, second: Any) -> Any:
        node = add(tree, "ShaderNodeMix", place, data_type="RGBA")
        for value, identifier in ((factor, "Factor_Float"), (first, "A_Color"), (second, "B_Color")):
            link(value, socket(node.inputs, identifier))
        return socket(node.outputs, "Result_Color")

    def product(place: tuple[float, float], a: Any, b: Any) -> Any:
        node = add(tree, "ShaderNodeMath", place, operation="MULTIPLY")
        link(a, node.inputs[0])
        link(b, node.inputs[1])
        return node.outputs[0]

    near = add(tree, "ShaderNodeMapRange", (-550, -150))  # 1 at a crack, 0 from the reach on
    near.inputs["To Min"].default_value, near.inputs["To Max"].default_value = 1.0, 0.0
    link(given["Distance"], near.inputs["Value"])
    link(given["Stain Reach"], near.inputs["From Max"])
    stain = product((-300, -150), near.outputs["Result"], given["Stain"])
    stained = mixed((-50, 100), stain, given["Color"], given["Stain Color"])
    crack = product((-300, 250), given["Mask"], given["Crack"])
    link(mixed((250, 100), crack, stained, given["Crack Color"]), made["Color"])

    height = product((-300, -400), given["Height"], given["Depth"])
    link(height, made["Height"])
    bump = add(tree, "ShaderNodeBump", (250, -300))
    bump.inputs["Distance"].default_value = 1.0
    link(height, bump.inputs["Height"])
    link(given["Normal"], bump.inputs["Normal"])
    link(bump.outputs["Normal"], made["Normal"])
