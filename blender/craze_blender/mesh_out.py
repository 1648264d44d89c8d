"""What the engine's process gives as a Blender mesh."""

from __future__ import annotations

import math
from contextlib import contextmanager
from typing import Any, Iterator

import bpy
import numpy as np

from . import layers, weights
from .nodes import new_material
from .work import holding
from .world import remove

WALL = "crack_wall"  # as the engine calls the material of side walls
WALL_COLOUR = (0.02, 0.015, 0.01, 1.0)


def _fill(mesh: Any, arrays: dict[str, np.ndarray]) -> Iterator[None]:
    """Gives an empty mesh its elements."""
    mesh.vertices.add(len(arrays["co"]))
    layers.put(mesh.vertices, "co", arrays["co"])
    yield
    mesh.edges.add(len(arrays["edges"]))
    layers.put(mesh.edges, "vertices", arrays["edges"])
    yield
    mesh.loops.add(len(arrays["loop_vertex"]))
    layers.put(mesh.loops, "vertex_index", arrays["loop_vertex"])
    yield
    layers.put(mesh.loops, "edge_index", arrays["loop_edge"])
    yield
    mesh.polygons.add(len(arrays["loop_start"]))
    layers.put(mesh.polygons, "loop_start", arrays["loop_start"])
    yield
    # From 3.6 on the starts say it.
    if not bpy.types.MeshPolygon.bl_rna.properties["loop_total"].is_readonly:
        layers.put(mesh.polygons, "loop_total", arrays["loop_total"])
    yield


def _wall_material() -> Any:
    material = bpy.data.materials.get(WALL)
    if material is None:
        material = new_material(WALL)
        material.diffuse_color = WALL_COLOUR
        shader = material.node_tree.nodes.get("Principled BSDF")
        if shader is not None:
            shader.inputs["Base Color"].default_value = WALL_COLOUR
            shader.inputs["Roughness"].default_value = 1.0
    return material


def _materials(source: Any, mesh: Any, walls: np.ndarray) -> None:
    for material in source.materials:
        mesh.materials.append(material)
    if walls.any():
        if not len(mesh.materials):
            mesh.materials.append(None)  # that of the surface
        mesh.materials.append(_wall_material())


@contextmanager
def _new_mesh(name: str) -> Iterator[Any]:
    """A mesh that is gone again if it does not get ready."""
    mesh, ready = bpy.data.meshes.new(name), False
    try:
        yield mesh
        ready = True
    finally:
        if not ready:
            remove([mesh])


def build(
    source: Any, groups: list[np.ndarray], names: list[str], name: str, arrays: dict[str, np.ndarray]
) -> Iterator[tuple[Any, list[str]] | None]:
    """A mesh of what worker/runs.py opened, with all layers of the mesh `source` and the vertex
    groups `groups` of these names. Yields None at each step, at last the mesh and the names of what
    could not be carried."""
    of = layers.maps(arrays)
    walls = arrays["wall"]
    with _new_mesh(name) as mesh, holding(source, mesh):
        yield from _fill(mesh, arrays)
        _materials(source, mesh, walls)
        lost = []
        for missing in layers.carry(source, mesh, of):
            lost += [missing] if missing else []
            yield None
        if walls.any():
            slot = len(mesh.materials) - 1
            yield from _changed(mesh.polygons, "material_index", np.int32, walls, slot)
            yield from _changed(mesh.polygons, "use_smooth", bool, walls, False)
        for key, values in arrays.items():
            domain, _, attribute = key.partition(" ")
            if attribute:
                layers.set_attribute(mesh, attribute, domain.upper(), values)
                yield None
        layers.set_attribute(mesh, "source_face", "FACE", np.where(walls, -1, arrays["face_source"]))
        yield None
        yield from _finish(source, mesh, groups, names, of, arrays["co"], walls)
        for key in source.keys():
            mesh[key] = source[key]
    yield mesh, lost


def copy_part(
    source: Any, groups: list[np.ndarray], names: list[str], name: str, arrays: dict[str, np.ndarray]
) -> Iterator[Any]:
    """A part of a cracked mesh, elements *_of, with all its layers; yields None at each step, at
    last the mesh."""
    of = {
        domain: layers.Maps(arrays[key][:, None], np.ones((len(arrays[key]), 1)))
        for domain, key in (
            ("POINT", "vertex_of"),
            ("EDGE", "edge_of"),
            ("CORNER", "loop_of"),
            ("FACE", "face_of"),
        )
    }
    with _new_mesh(name) as mesh, holding(source, mesh):
        yield from _fill(mesh, arrays)
        for material in source.materials:
            mesh.materials.append(material)
        for _ in layers.carry(source, mesh, of):
            yield None
        none = np.zeros(len(arrays["loop_start"]), bool)
        yield from _finish(source, mesh, groups, names, of, arrays["co"], none)
    yield mesh


def _finish(
    source: Any, mesh: Any, groups: list[np.ndarray], names: list[str], of: dict[str, layers.Maps],
    co: np.ndarray, walls: np.ndarray,
) -> Iterator[None]:  # fmt: skip
    """What needs a mesh that has its elements: normals, weights and shape keys."""
    mesh.update(calc_edges_loose=True)
    yield
    yield from _normals(source, mesh, of["CORNER"], walls)
    double = bpy.data.objects.new(mesh.name, mesh)  # groups and keys are made through an object
    try:
        with holding(double):
            for group, values in zip(names, groups):
                mixed = yield from weights.mixed_group(values, of["POINT"])
                yield from weights.write_group(double, group, mixed)
            yield from weights.carry_keys(source, double, of["POINT"], co)
    finally:
        remove([double])


def _changed(
    collection: Any, name: str, dtype: Any, which: np.ndarray, value: Any
) -> Iterator[None]:
    """Gives some elements another value."""
    values = layers.get(collection, name, dtype)
    values[which] = value
    yield
    layers.put(collection, name, values)
    yield


def _sharpen(mesh: Any, walls: np.ndarray) -> Iterator[None]:
    """Edges of walls are hard: a smooth surface does not bend into its cracks."""
    corners = np.repeat(walls, layers.get(mesh.polygons, "loop_total", np.int32))
    edges = layers.get(mesh.loops, "edge_index", np.int32)[corners]
    yield
    yield from _changed(mesh.edges, "use_edge_sharp", bool, edges, True)
    if hasattr(mesh, "use_auto_smooth") and not mesh.use_auto_smooth:  # before 4.1
        mesh.use_auto_smooth = True
        mesh.auto_smooth_angle = math.pi  # what is not marked stays smooth


def _normals(source: Any, mesh: Any, of: layers.Maps, walls: np.ndarray) -> Iterator[None]:
    if hasattr(source, "use_auto_smooth"):  # before 4.1
        mesh.use_auto_smooth = source.use_auto_smooth
        mesh.auto_smooth_angle = source.auto_smooth_angle
    if walls.any():
        yield from _sharpen(mesh, walls)
    known = layers.custom_normals(source)
    if known is not None:
        yield
        normals = yield from layers.taken(of, known)
        normals[np.repeat(walls, layers.get(mesh.polygons, "loop_total", np.int32))] = 0
        yield
        layers.set_custom_normals(mesh, normals)
        yield
