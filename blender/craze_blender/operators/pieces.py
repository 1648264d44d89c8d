"""bpy.ops.craze.pieces(): each fragment an object, ready to fall."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np
from mathutils import Matrix

from .. import cracked, layers, mesh_out, weights
from ..work import Problem, Steps, last
from .base import OfCracked


class CRAZE_OT_pieces(OfCracked, bpy.types.Operator):
    """Splits the cracked object into its fragments: objects with their own origins, made solid by a
    Solidify modifier instead of side walls, with rigid bodies"""

    bl_idname = "craze.pieces"
    bl_label = "Pieces"

    thickness: bpy.props.FloatProperty(
        name="Thickness",
        description="Of each piece, inwards, in the scene's unit; 0: as the fragments are",
        min=0.0,
        subtype="DISTANCE",
        unit="LENGTH",
        options={"SKIP_SAVE"},
    )
    rigid_body: bpy.props.BoolProperty(
        name="Rigid body", description="Pieces fall and hit each other", default=True
    )

    def steps(self, context: Any) -> Steps:
        thing = context.active_object
        mesh = thing.data
        said = self.properties.is_property_set("thickness")
        thickness = self.thickness if said else context.scene.craze.thickness
        if "fragment" not in mesh.attributes:
            raise Problem("the object has no attribute \"fragment\"")
        kept = _no_walls(mesh) if thickness > 0 else np.ones(len(mesh.polygons), bool)
        names = cracked.group_names(thing)
        groups = yield from last(weights.read_groups(mesh, len(thing.vertex_groups)))
        fragment = layers.get(mesh.attributes["fragment"].data, "value", np.int32)
        shape = _Shape(mesh)
        made: list[Any] = []
        done = False
        try:
            for number in np.unique(fragment):
                arrays = shape.part(np.flatnonzero((fragment == number) & kept))
                name = f"{thing.name} fragment {number}"
                part = yield from last(mesh_out.copy_part(mesh, groups, names, name, arrays))
                made.append(part)
                yield
            done = True
        finally:
            if not done:
                for part in made:
                    bpy.data.meshes.remove(part)
        self._link(context, thing, made, thickness)
        return f"{len(made)} pieces"

    def _link(self, context: Any, thing: Any, made: list[Any], thickness: float) -> None:
        collection = bpy.data.collections.new(f"{thing.name} pieces")
        context.scene.collection.children.link(collection)
        objects = []
        for mesh in made:
            piece = bpy.data.objects.new(mesh.name, mesh)
            for group in thing.vertex_groups:
                if group.name not in piece.vertex_groups:
                    piece.vertex_groups.new(name=group.name)
            centre = _to_centre(mesh)
            piece.matrix_world = thing.matrix_world @ _moved(centre)
            collection.objects.link(piece)
            if thickness > 0:
                solid = piece.modifiers.new("Thickness", "SOLIDIFY")
                solid.thickness = thickness
                solid.offset = -1.0
                # Rims are as side walls are, where there were some.
                if mesh_out.WALL in mesh.materials:
                    solid.material_offset_rim = len(mesh.materials) - 1
            objects.append(piece)
        if self.rigid_body:
            _make_rigid(context, objects)
        thing.hide_set(True)
        thing.hide_render = True


def _no_walls(mesh: Any) -> np.ndarray:
    """(p,) bool: what a Solidify modifier is to thicken, which makes walls of its own."""
    return layers.get(mesh.attributes["source_face"].data, "value", np.int32) >= 0


def _moved(by: np.ndarray) -> Any:
    return Matrix.Translation([float(x) for x in by])


def _to_centre(mesh: Any) -> np.ndarray:
    """Moves a mesh so that the middle of its vertices is its origin; gives that middle."""
    co = layers.get(mesh.vertices, "co", np.float32, 3)
    centre = co.mean(axis=0, dtype=np.float64).astype(np.float32)
    mesh.transform(_moved(-centre), shape_keys=True)
    return centre


def _make_rigid(context: Any, objects: list[Any]) -> None:
    scene = context.scene
    if scene.rigidbody_world is None:
        bpy.ops.rigidbody.world_add()
    if scene.rigidbody_world.collection is None:
        scene.rigidbody_world.collection = bpy.data.collections.new("RigidBodyWorld")
    for piece in objects:
        scene.rigidbody_world.collection.objects.link(piece)
        if piece.rigid_body is not None:
            piece.rigid_body.collision_shape = "CONVEX_HULL"


class _Shape:
    """A mesh's topology, to take parts of."""

    def __init__(self, mesh: Any) -> None:
        self.co = layers.get(mesh.vertices, "co", np.float32, 3)
        self.edges = layers.get(mesh.edges, "vertices", np.int32, 2)
        self.loop_vertex = layers.get(mesh.loops, "vertex_index", np.int32)
        self.loop_edge = layers.get(mesh.loops, "edge_index", np.int32)
        self.loop_start = layers.get(mesh.polygons, "loop_start", np.int32)
        self.loop_total = layers.get(mesh.polygons, "loop_total", np.int32)

    def part(self, polygons: np.ndarray) -> dict[str, np.ndarray]:
        """The arrays that mesh_out.copy_part() takes."""
        total = self.loop_total[polygons]
        start = np.cumsum(total) - total
        within = np.arange(total.sum()) - np.repeat(start, total)
        loops = np.repeat(self.loop_start[polygons], total) + within
        vertices, loop_vertex = np.unique(self.loop_vertex[loops], return_inverse=True)
        edges, loop_edge = np.unique(self.loop_edge[loops], return_inverse=True)
        return {
            "co": self.co[vertices],
            "edges": np.searchsorted(vertices, self.edges[edges]).astype(np.int32),
            "loop_vertex": loop_vertex.astype(np.int32),
            "loop_edge": loop_edge.astype(np.int32),
            "loop_start": start.astype(np.int32),
            "loop_total": total.astype(np.int32),
            "vertex_of": vertices,
            "edge_of": edges,
            "loop_of": loops,
            "face_of": polygons,
        }


CLASSES = [CRAZE_OT_pieces]
