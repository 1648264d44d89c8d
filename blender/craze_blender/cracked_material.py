"""Materials with baked cracks: an object's own, with pictures and the node group beside them."""

from __future__ import annotations

from typing import Any

import bpy

from . import crack_nodes, mesh_out
from .nodes import add, give_nodes, has_nodes

USED = ("mask", "height", "distance")  # the maps that the group takes
PREFIX = "Craze "  # of the names of our nodes


def wire(
    thing: Any, uv: str, images: dict[tuple[str, str], Any], sets: dict[str, str], reach: float
) -> list[str]:
    """Gives a cracked object materials that show maps, images by (texture set, map), in the UV map
    `uv`; `sets` are those of material slots, {} where there is one; `reach` is how far stains go at
    first, a length. Materials are copied, so that other objects keep theirs; those that have cracks
    take the new images. Returns what could not be done."""
    slots = thing.data.materials
    if not len(slots):
        slots.append(None)
    troubles, made = [], {}
    for index, old in enumerate(slots):
        key = old.name if old is not None else ""
        of = sets.get(str(index), "")
        if key == mesh_out.WALL or (sets and not of):
            continue  # of no face that has maps
        if key not in made:
            new = _own(thing, old)
            made[key] = new
            pictures = {name: images[of, name] for name in USED}
            if not _show(new.node_tree, pictures, uv, reach):
                troubles.append(f"{new.name} has no Principled BSDF that could show cracks")
        slots[index] = made[key]
    return troubles


def _own(thing: Any, old: Any) -> Any:
    """A material that may be changed."""
    if old is None:
        new = bpy.data.materials.new(f"{thing.name} surface")
    elif has_nodes(old) and crack_nodes.GROUP in old.node_tree.nodes:
        return old
    else:
        new = old.copy()
        new.name = f"{old.name} cracks"
    if not has_nodes(new):
        colour = tuple(new.diffuse_color)
        give_nodes(new)
        shader = principled(new.node_tree)
        if shader is not None:
            shader.inputs["Base Color"].default_value = colour
    return new


def principled(tree: Any) -> Any:
    """Its Principled BSDF, or None."""
    return next((n for n in tree.nodes if n.bl_idname == "ShaderNodeBsdfPrincipled"), None)


def _show(tree: Any, pictures: dict[str, Any], uv: str, reach: float) -> bool:
    """Puts pictures before the group, which is made and wired where there is none. False: there is
    nothing to wire it to."""
    group = tree.nodes.get(crack_nodes.GROUP)
    if group is None:
        group = add(tree, "ShaderNodeGroup", (-300, -100), node_tree=crack_nodes.crack_group())
        group.name = group.label = crack_nodes.GROUP
        group.inputs["Stain Reach"].default_value = reach
        _wire_shader(tree, group)
    places = tree.nodes.get(PREFIX + "UV") or add(tree, "ShaderNodeUVMap", (-950, -300))
    places.name, places.uv_map = PREFIX + "UV", uv
    for row, (name, image) in enumerate(pictures.items()):
        node = tree.nodes.get(PREFIX + name)
        if node is None:
            node = add(tree, "ShaderNodeTexImage", (-700, -100 - 280 * row))
            node.name = node.label = PREFIX + name
            tree.links.new(places.outputs["UV"], node.inputs["Vector"])
            tree.links.new(node.outputs["Color"], group.inputs[name.capitalize()])
        old, node.image = node.image, image
        if old is not None and old != image and old.users == 0:
            bpy.data.images.remove(old)
    return bool(group.outputs["Color"].is_linked)


def _wire_shader(tree: Any, group: Any) -> None:
    """The group comes before the shader's colour and normal, and takes what was there."""
    shader = principled(tree)
    if shader is None:
        return
    link = tree.links.new
    colour, normal = shader.inputs["Base Color"], shader.inputs["Normal"]
    if colour.is_linked:
        link(colour.links[0].from_socket, group.inputs["Color"])
    else:
        group.inputs["Color"].default_value = colour.default_value
    if normal.is_linked:
        before = normal.links[0].from_socket
    else:
        before = add(tree, "ShaderNodeNewGeometry", (-550, 200)).outputs["Normal"]
    link(before, group.inputs["Normal"])
    link(group.outputs["Color"], colour)
    link(group.outputs["Normal"], normal)
