"""bpy.ops.craze.pieces(): each fragment an object, ready to fall."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator

import bpy
import numpy as np
from mathutils import Matrix, Vector

from .. import changes, cracked, layers, mesh_out, process, runs, weights
from ..work import Problem, Steps, holding, last
from ..world import hide, placed, remove
from .base import OfCracked

DENSITY = 2000.0  # kg/m³, about that of clay, plaster and glaze; only ratios count for the look
LEAST_MASS = 0.001  # kg: Blender takes no less


class CRAZE_OT_pieces(OfCracked, bpy.types.Operator):
    """Splits the cracked object into its fragments: objects with their own origins, closed solids
    where there is a thickness, with rigid bodies"""

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
    core: bpy.props.BoolProperty(
        name="Core",
        description="What is left inside a closed surface is one more piece, which stays",
        options={"SKIP_SAVE"},
    )
    rigid_body: bpy.props.BoolProperty(
        name="Rigid body", description="Pieces fall and hit each other", default=True
    )

    def steps(self, context: Any) -> Steps:
        thing, scene = context.active_object, context.scene
        said = self.properties.is_property_set
        thickness = self.thickness if said("thickness") else context.scene.craze.thickness
        core = self.core if said("core") else context.scene.craze.core
        if thickness > 0 and (yield from changes.edited(thing)):
            self.report({"WARNING"}, f"craze: {thing.name} was changed by hand; solid pieces are of "
                        "what was cracked, without that")  # fmt: skip
        if thickness > 0:
            solid = yield from _solid(thing, thickness, core)
            try:
                cracked.keep_materials(thing.data, solid.mesh)
                made = yield from _parts(thing, solid.mesh)
                warnings = solid.warnings
                bodies = [_Body(row[0], row[1:], mesh) for row, mesh in zip(solid.solids, made)]
            finally:
                remove([solid.mesh])
        else:
            if "fragment" not in thing.data.attributes:
                raise Problem("the object has no attribute \"fragment\"")
            made = yield from _parts(thing, thing.data)
            warnings = []
            bodies = [_Body(0.0, _middle(mesh), mesh) for mesh in made]
        yield from _gathered(scene, thing, bodies, self.rigid_body)
        hide(thing)
        for warning in warnings:
            self.report({"WARNING"}, f"craze: {warning}")
        return f"{len(made)} pieces"


@dataclass
class _Body:
    """A piece. `volume`: 0 where it is not closed; `centre`: where its origin goes."""

    volume: float
    centre: np.ndarray
    mesh: Any
    object: Any = None

    @property
    def is_core(self) -> bool:
        """Whether nothing of it was ever outside."""
        source = layers.get(self.mesh.attributes["source_face"].data, "value", np.int32)
        return bool((source < 0).all())


def _solid(thing: Any, thickness: float, core: bool) -> Steps:
    """runs.Made of the object's run, its fragments closed by the engine."""
    post = {**cracked.post_of(thing), "thickness": thickness, "core": core}
    order = cracked.order_of(thing)
    return (yield from runs.open_again(process.engine(), order, thing.data.name, post))


def _parts(thing: Any, mesh: Any) -> Steps:
    """A mesh per fragment of a mesh, in their order, with all layers of it."""
    names = cracked.group_names(thing)
    with holding(mesh):
        groups = yield from last(weights.read_groups(mesh, len(thing.vertex_groups)))
    fragment = layers.get(mesh.attributes["fragment"].data, "value", np.int32)
    yield
    shape = _Shape(mesh)
    yield
    numbers = np.unique(fragment)
    yield
    made: list[Any] = []
    done = False
    try:
        for number in numbers:
            arrays = yield from shape.part(np.flatnonzero(fragment == number))
            name = f"{thing.name} fragment {number}"
            part = yield from last(mesh_out.copy_part(mesh, groups, names, name, arrays))
            made.append(part)
            yield
        done = True
    finally:
        if not done:
            remove(made)
    return made


def _gathered(scene: Any, thing: Any, bodies: list[_Body], rigid: bool) -> Iterator[None]:
    """Makes the objects of bodies, their origins at the centres, in a new collection; all are gone
    again if they do not get ready."""
    collection = bpy.data.collections.new(f"{thing.name} pieces")
    plain, sheared = placed(thing.matrix_world)
    done = False
    try:
        for body in bodies:
            piece = body.object = bpy.data.objects.new(body.mesh.name, body.mesh)
            for group in thing.vertex_groups:
                if group.name not in piece.vertex_groups:
                    piece.vertex_groups.new(name=group.name)
            body.mesh.transform(sheared @ _moved(-body.centre), shape_keys=True)
            piece.matrix_world = plain @ _moved(sheared @ Vector(body.centre.tolist()))
            collection.objects.link(piece)
            yield
        scene.collection.children.link(collection)
        if rigid:
            yield
            yield from _make_rigid(scene, bodies)
        done = True
    finally:
        if not done:
            made = [body.object for body in bodies if body.object is not None]
            remove([collection, *made, *(body.mesh for body in bodies)])


def _moved(by: Any) -> Any:
    return Matrix.Translation([float(x) for x in by])


def _middle(mesh: Any) -> np.ndarray:
    """Of the vertices."""
    co = layers.get(mesh.vertices, "co", np.float32, 3)
    return co.mean(axis=0, dtype=np.float64).astype(np.float32)


def _make_rigid(scene: Any, bodies: list[_Body]) -> Iterator[None]:
    if scene.rigidbody_world is None:
        with bpy.context.temp_override(scene=scene):
            bpy.ops.rigidbody.world_add()
        yield
    world = scene.rigidbody_world
    if world.collection is None:
        world.collection = bpy.data.collections.new("RigidBodyWorld")
    # Hulls of neighbours overlap where pieces are hollow: they part without being thrown apart.
    world.use_split_impulse = True
    for body in bodies:
        yield
        world.collection.objects.link(body.object)
        rigid = body.object.rigid_body
        if rigid is None:
            continue
        rigid.collision_shape = "CONVEX_HULL"
        if body.volume > 0:
            # Neighbours touch.
            rigid.use_margin, rigid.collision_margin = True, 0.0
            rigid.mass = max(DENSITY * body.volume, LEAST_MASS)
            if body.is_core:
                rigid.type = "PASSIVE"


class _Shape:
    """A mesh's topology, to take parts of."""

    def __init__(self, mesh: Any) -> None:
        self.co = layers.get(mesh.vertices, "co", np.float32, 3)
        self.edges = layers.get(mesh.edges, "vertices", np.int32, 2)
        self.loop_vertex = layers.get(mesh.loops, "vertex_index", np.int32)
        self.loop_edge = layers.get(mesh.loops, "edge_index", np.int32)
        self.loop_start = layers.get(mesh.polygons, "loop_start", np.int32)
        self.loop_total = layers.get(mesh.polygons, "loop_total", np.int32)

    def part(self, polygons: np.ndarray) -> Steps:
        """The arrays that mesh_out.copy_part() takes."""
        total = self.loop_total[polygons]
        start = np.cumsum(total) - total
        within = np.arange(total.sum()) - np.repeat(start, total)
        loops = np.repeat(self.loop_start[polygons], total) + within
        yield
        vertices, loop_vertex = _used(self.loop_vertex[loops], len(self.co))
        yield
        edges, loop_edge = _used(self.loop_edge[loops], len(self.edges))
        yield
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


def _used(indices: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """As np.unique(indices, return_inverse=True) of numbers below `count`, without sorting many."""
    if len(indices) < count // 20:
        return np.unique(indices, return_inverse=True)
    there = np.zeros(count, bool)
    there[indices] = True
    return np.flatnonzero(there), (np.cumsum(there) - 1)[indices]


CLASSES = [CRAZE_OT_pieces]
