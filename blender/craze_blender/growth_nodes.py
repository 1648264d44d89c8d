"""The geometry node group "Craze Growth": a slider opens the cracks one after the other."""

from __future__ import annotations

from typing import Any

import bpy

from .nodes import add, new_socket

GROUP = "Craze Growth"
SLIDER = "Growth"
TIME, MOVE = "crack_growth", "crack_opening"  # attributes: when a place opens, and how far it goes
OPENING_TIME = 0.05  # of the growth, that a place takes; as in the engine's own growth


def growth_group() -> Any:
    """The group of this file, made where there is none: at 0 each vertex is back by its attribute
    crack_opening, from its time crack_growth on it moves to where it is."""
    known = bpy.data.node_groups.get(GROUP)
    if known is not None and known.bl_idname == "GeometryNodeTree":
        return known
    tree = bpy.data.node_groups.new(GROUP, "GeometryNodeTree")
    if hasattr(tree, "is_modifier"):  # 4.0 and later
        tree.is_modifier = True
    new_socket(tree, "INPUT", "Geometry", "NodeSocketGeometry")
    slider = new_socket(tree, "INPUT", SLIDER, "NodeSocketFloat")
    slider.default_value, slider.min_value, slider.max_value = 1.0, 0.0, 1.0
    new_socket(tree, "OUTPUT", "Geometry", "NodeSocketGeometry")
    _fill(tree)
    return tree


def slider_of(tree: Any) -> str:
    """By which a modifier knows the slider."""
    inputs = tree.interface.items_tree if hasattr(tree, "interface") else tree.inputs
    return str(next(s.identifier for s in inputs if s.name == SLIDER))


def _fill(tree: Any) -> None:
    given = add(tree, "NodeGroupInput", (-800, 0)).outputs
    made = add(tree, "NodeGroupOutput", (400, 0)).inputs
    link = tree.links.new

    def attribute(name: str, kind: str, place: tuple[float, float]) -> Any:
        node = add(tree, "GeometryNodeInputNamedAttribute", place, data_type=kind)
        node.inputs["Name"].default_value = name
        return next(s for s in node.outputs if s.enabled and s.name == "Attribute")

    begin = attribute(TIME, "FLOAT", (-800, -150))
    end = add(tree, "ShaderNodeMath", (-600, -250), operation="ADD")
    end.inputs[1].default_value = OPENING_TIME
    link(begin, end.inputs[0])
    back = add(tree, "ShaderNodeMapRange", (-400, -100), interpolation_type="SMOOTHSTEP")
    back.inputs["To Min"].default_value, back.inputs["To Max"].default_value = -1.0, 0.0
    link(given[SLIDER], back.inputs["Value"])
    link(begin, back.inputs["From Min"])
    link(end.outputs[0], back.inputs["From Max"])
    offset = add(tree, "ShaderNodeVectorMath", (-150, -200), operation="SCALE")
    link(attribute(MOVE, "FLOAT_VECTOR", (-400, -400)), offset.inputs[0])
    link(back.outputs["Result"], offset.inputs["Scale"])
    move = add(tree, "GeometryNodeSetPosition", (150, 0))
    link(given["Geometry"], move.inputs["Geometry"])
    link(offset.outputs["Vector"], move.inputs["Offset"])
    link(move.outputs["Geometry"], made["Geometry"])
