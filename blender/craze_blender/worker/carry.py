"""Where everything of a cracked mesh lies in the mesh that it was made of.

The engine takes triangles, a corner each of a polygon; a Blender mesh has layers that it does not
know: any number of UV maps, weights, shape keys, seams. They are carried by place. Each output face
knows its source triangle, each output vertex its place at rest on the source; so each corner has
barycentric weights in that triangle, and where it is a corner of it the weights are 1, 0, 0, to
the bit.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

# Closer to an edge or a corner than this part of the triangle is on it. Blender's own numbers
# (float32) tell no less.
ON_IT = 1e-6


@dataclass(frozen=True)
class Source:
    """A Blender mesh.

    places (n, 3) float64, as the engine sees them; edges (e, 2); loop_vertex (l,); loop_start (p,);
    loop_total (p,); triangles (m, 3) of loops; triangle_polygon (m,). Indices are int32.
    """

    places: np.ndarray
    edges: np.ndarray
    loop_vertex: np.ndarray
    loop_start: np.ndarray
    loop_total: np.ndarray
    triangles: np.ndarray
    triangle_polygon: np.ndarray


def weights_in(triangles: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(c, 3) float64: barycentric weights of points (c, 3) in triangles (c, 3, 3), of the nearest
    corner alone where a triangle has no area. Not cut to 0 … 1."""
    first = triangles[:, 0]
    u, v, p = triangles[:, 1] - first, triangles[:, 2] - first, points - first

    def dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.einsum("ij,ij->i", a, b)

    uu, uv, vv, pu, pv = dot(u, u), dot(u, v), dot(v, v), dot(p, u), dot(p, v)
    area = uu * vv - uv * uv
    flat = area <= 1e-24 * uu * vv
    area = np.where(flat, 1.0, area)
    second = (vv * pu - uv * pv) / area
    third = (uu * pv - uv * pu) / area
    weights = np.stack([1.0 - second - third, second, third], axis=1)
    if flat.any():
        distance = np.linalg.norm(triangles[flat] - points[flat][:, None], axis=2)
        weights[flat] = np.eye(3)[distance.argmin(axis=1)]
    return weights


def settled(weights: np.ndarray) -> np.ndarray:
    """Weights ≥ 0 of sum 1; what is nearly on an edge or a corner is on it."""
    inside = np.where(weights < ON_IT, 0.0, weights)
    inside /= inside.sum(axis=1, keepdims=True)
    at = inside > 1.0 - ON_IT
    corner = at.any(axis=1)
    inside[corner] = at[corner]
    return inside


@dataclass(frozen=True)
class Carried:
    """Per vertex three source vertices and weights; per corner three source loops and weights; per
    polygon a source polygon; per edge a source edge, −1: none."""

    loop_vertex: np.ndarray
    loop_edge: np.ndarray
    loop_start: np.ndarray
    loop_total: np.ndarray
    edges: np.ndarray
    wall: np.ndarray  # (p,) bool
    triangle: np.ndarray  # (p,): an output triangle of each polygon
    point_source: np.ndarray
    point_weight: np.ndarray
    corner_source: np.ndarray
    corner_weight: np.ndarray
    face_source: np.ndarray
    edge_source: np.ndarray


def carry(
    source: Source, faces: np.ndarray, rest: np.ndarray, origin: np.ndarray, walls: np.ndarray
) -> Carried:
    """For output triangles `faces` (f, 3) of vertices at rest at `rest` (v, 3); `origin` (f,) is
    the source triangle, walls having that of their rim; `walls` (f,) bool. A polygon whose
    triangles are all there, untouched, is one polygon again."""
    loops = source.triangles[origin]  # (f, 3)
    corners = source.places[source.loop_vertex[loops]]  # (f, 3, 3)
    raw = weights_in(np.repeat(corners, 3, axis=0), rest[faces].reshape(-1, 3))
    weight = settled(raw)
    corner_loops = np.repeat(loops, 3, axis=0)  # (3 f, 3)

    point = _best_corner(faces.reshape(-1), raw, len(rest))
    point_source = source.loop_vertex[corner_loops[point]]
    point_weight = weight[point]

    whole = _whole_polygons(source, faces, origin, walls, weight.reshape(-1, 3, 3))
    keep = ~whole[origin] | walls
    loose = np.flatnonzero(keep)
    whole_loops, whole_vertices, whole_polygons, whole_triangles = _joined(
        source, faces, origin, ~keep, weight.reshape(-1, 3, 3)
    )

    rows = (3 * loose[:, None] + np.arange(3)).reshape(-1)
    unit = np.zeros((len(whole_loops), 3))
    unit[:, 0] = 1.0
    loop_vertex = np.concatenate([whole_vertices, faces[loose].reshape(-1)]).astype(np.int32)
    corner_source = np.concatenate(
        [np.repeat(whole_loops[:, None], 3, axis=1), corner_loops[rows]]
    ).astype(np.int32)
    corner_weight = np.concatenate([unit, weight[rows]])
    loop_total = np.concatenate(
        [source.loop_total[whole_polygons], np.full(len(loose), 3)]
    ).astype(np.int32)
    loop_start = (np.cumsum(loop_total) - loop_total).astype(np.int32)
    face_source = np.concatenate(
        [whole_polygons, source.triangle_polygon[origin[loose]]]
    ).astype(np.int32)
    wall = np.concatenate([np.zeros(len(whole_polygons), bool), walls[loose]])
    triangle = np.concatenate([whole_triangles, loose]).astype(np.int32)

    edges, loop_edge, edge_source = _edges(
        source, loop_vertex, loop_start, loop_total, corner_source, corner_weight
    )
    return Carried(
        loop_vertex, loop_edge, loop_start, loop_total, edges, wall, triangle,
        point_source.astype(np.int32), point_weight, corner_source, corner_weight,
        face_source, edge_source,
    )  # fmt: skip


def _best_corner(vertex: np.ndarray, raw: np.ndarray, count: int) -> np.ndarray:
    """(count,): of each vertex the first corner that is least outside of its source triangle."""
    outside = np.maximum(-raw.min(axis=1), ON_IT)
    least = np.full(count, np.inf)
    np.minimum.at(least, vertex, outside)
    rows = np.flatnonzero(outside == least[vertex])[::-1]
    best = np.zeros(count, np.int64)
    best[vertex[rows]] = rows  # the last one stays: the first corner
    return best


def _same_corners(weight: np.ndarray) -> np.ndarray:
    """(f,) bool: the output triangle is its source triangle, turned at most."""
    at = weight.argmax(axis=2)
    exact = (weight.max(axis=2) == 1.0).all(axis=1)
    return exact & (at[:, 1] == (at[:, 0] + 1) % 3) & (at[:, 2] == (at[:, 0] + 2) % 3)


def _whole_polygons(
    source: Source, faces: np.ndarray, origin: np.ndarray, walls: np.ndarray, weight: np.ndarray
) -> np.ndarray:
    """(m,) bool by source triangle: its polygon, of more than one triangle or not, is there whole,
    its triangles sharing their vertices."""
    polygons = len(source.loop_start)
    polygon = source.triangle_polygon
    tops = ~walls
    there = np.bincount(polygon[origin[tops]], minlength=polygons)
    same = tops & _same_corners(weight)
    untouched = np.bincount(polygon[origin[same]], minlength=polygons)
    wanted = np.bincount(polygon, minlength=polygons)
    whole = (there == wanted) & (untouched == wanted) & (wanted > 0)
    # Each loop of the polygon must be one output vertex, whichever triangle it is asked of.
    rows = np.flatnonzero(same & whole[polygon[origin]])
    at = weight[rows].argmax(axis=2)
    loop = np.take_along_axis(source.triangles[origin[rows]], at, axis=1).reshape(-1)
    vertex = faces[rows].reshape(-1)
    low = np.full(len(source.loop_vertex), np.iinfo(np.int64).max)
    high = np.full(len(source.loop_vertex), -1, np.int64)
    np.minimum.at(low, loop, vertex)
    np.maximum.at(high, loop, vertex)
    parted = (low != high) & (high >= 0)
    torn = np.repeat(np.arange(polygons), source.loop_total)[_ordered(source, parted)]
    whole[torn] = False
    return whole[polygon]


def _ordered(source: Source, of_loops: np.ndarray) -> np.ndarray:
    """Values of loops in the order of their polygons."""
    total = source.loop_total
    begin = np.cumsum(total) - total
    within = np.arange(total.sum()) - np.repeat(begin, total)
    return of_loops[np.repeat(source.loop_start, total) + within]


def _joined(
    source: Source, faces: np.ndarray, origin: np.ndarray, joined: np.ndarray, weight: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Loops, vertices, polygons and an output triangle of each polygon of those that are whole,
    in the order of the source."""
    rows = np.flatnonzero(joined)
    at = weight[rows].argmax(axis=2)
    loop = np.take_along_axis(source.triangles[origin[rows]], at, axis=1).reshape(-1)
    vertex_of = np.zeros(len(source.loop_vertex), np.int64)
    vertex_of[loop] = faces[rows].reshape(-1)
    triangle_of = np.zeros(len(source.loop_start), np.int64)
    triangle_of[source.triangle_polygon[origin[rows]]] = rows
    polygons = np.unique(source.triangle_polygon[origin[rows]])
    total = source.loop_total[polygons]
    begin = np.cumsum(total) - total
    within = np.arange(total.sum()) - np.repeat(begin, total)
    loops = np.repeat(source.loop_start[polygons], total) + within
    return loops, vertex_of[loops], polygons, triangle_of[polygons]


def _pairs(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """One number for two vertices in either order."""
    low, high = np.minimum(a, b).astype(np.int64), np.maximum(a, b).astype(np.int64)
    return low << 32 | high


def _edges(
    source: Source,
    loop_vertex: np.ndarray,
    loop_start: np.ndarray,
    loop_total: np.ndarray,
    corner_source: np.ndarray,
    corner_weight: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Edges (e, 2), the edge of each loop, and the source edge that an edge lies on, or −1."""
    following = np.arange(1, len(loop_vertex) + 1)
    following[loop_start + loop_total - 1] = loop_start
    pair = _pairs(loop_vertex, loop_vertex[following])
    unique, loop_edge = np.unique(pair, return_inverse=True)
    edges = np.stack([unique >> 32, unique & 0xFFFFFFFF], axis=1).astype(np.int32)

    found = np.full(len(unique), -1, np.int32)
    known = _pairs(source.edges[:, 0], source.edges[:, 1])
    order = np.argsort(known, kind="stable")
    if len(known):
        # Of every loop, since of the two faces at an edge one may not lie on the source's edge.
        here = np.arange(len(loop_vertex))
        a, b = _source_ends(source, corner_source, corner_weight, here, following)
        wanted = _pairs(a, b)
        spot = np.minimum(np.searchsorted(known[order], wanted), len(known) - 1)
        match = (a >= 0) & (known[order][spot] == wanted)
        found[loop_edge[match]] = order[spot[match]]
    return edges, loop_edge.astype(np.int32).reshape(-1), found


def _source_ends(
    source: Source,
    corner_source: np.ndarray,
    corner_weight: np.ndarray,
    here: np.ndarray,
    there: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """The source vertices of the source edge that both corners lie on; −1, −1: none."""
    same = (corner_source[here] == corner_source[there]).all(axis=1)
    # Corners of joined polygons name one loop each: the edge is that between the two.
    single = (corner_source[here] == corner_source[here][:, :1]).all(axis=1) & (
        corner_source[there] == corner_source[there][:, :1]
    ).all(axis=1)
    off = (corner_weight[here] == 0.0) & (corner_weight[there] == 0.0)
    opposite = off.argmax(axis=1)
    on = same & off.any(axis=1)
    vertices = source.loop_vertex[corner_source[here]]
    row = np.arange(len(here))
    a = np.where(on, vertices[row, (opposite + 1) % 3], -1)
    b = np.where(on, vertices[row, (opposite + 2) % 3], -1)
    a = np.where(single, source.loop_vertex[corner_source[here][:, 0]], a)
    b = np.where(single, source.loop_vertex[corner_source[there][:, 0]], b)
    return a, b
