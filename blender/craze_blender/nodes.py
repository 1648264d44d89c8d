"""Node trees in 3.4 and in 4.x."""

from __future__ import annotations

from typing import Any

import bpy


def new_material(name: str) -> Any:
    """One with nodes: a Principled BSDF and an output."""
    material = bpy.data.materials.new(name)
    give_nodes(material)
    return material


def has_nodes(material: Any) -> bool:
    """From 5.0 on all have; before, they may be switched off."""
    return material.node_tree is not None and getattr(material, "use_nodes", True)


def give_nodes(material: Any) -> None:
    if not has_nodes(material) and hasattr(material, "use_nodes"):
        material.use_nodes = True


def new_socket(tree: Any, side: str, name: str, kind: str) -> Any:
    """A socket of a group; `side` is INPUT or OUTPUT."""
    if hasattr(tree, "interface"):  # 4.0 and later
        return tree.interface.new_socket(name, in_out=side, socket_type=kind)
    return (tree.inputs if side == "INPUT" else tree.outputs).new(kind, name)


def add(tree: Any, kind: str, place: tuple[float, float], **properties: Any) -> Any:
    """A new node."""
    node = tree.nodes.new(kind)
    node.location = place
    for name, value in properties.items():
        setattr(node, name, value)
    return node


def socket(sockets: Any, identifier: str) -> Any:
    """A socket by its identifier: those of a Mix node share names."""
    return next(s for s in sockets if s.identifier == identifier)
