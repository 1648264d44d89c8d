"""Vertex groups and shape keys. Both are made through an object that has the mesh."""

from __future__ import annotations

from typing import Any, Generator, Iterator

import numpy as np

from . import layers

CHUNK = 1000  # vertices read, or weights written, at a step
BLOCK = 1 << 14  # vertices whose weights are sorted at a step


def read_groups(mesh: Any, count: int) -> Iterator[list[np.ndarray] | None]:
    """Yields None at each step, then of each of `count` groups the weight of each vertex (n,)
    float32, NaN where it is not in the group."""
    groups = [np.full(len(mesh.vertices), np.nan, np.float32) for _ in range(count)]
    if count:
        for begin in range(0, len(mesh.vertices), CHUNK):
            for vertex in mesh.vertices[begin : begin + CHUNK]:
                for entry in vertex.groups:
                    if entry.group < count:
                        groups[entry.group][vertex.index] = entry.weight
            yield None
    yield groups


def mixed_group(group: np.ndarray, of: layers.Maps) -> Generator[None, None, np.ndarray]:
    """The same per output vertex. Between members of a group and others, the others count 0."""
    made = []
    for part in of.parts:
        values = part.mixed(np.nan_to_num(group)[:, None])[:, 0]
        member = np.isfinite(group)[part.index] & (part.weight > 0)
        values[~member.any(axis=1)] = np.nan
        made.append(values)
        yield
    return np.concatenate(made) if made else np.empty(0, np.float32)


def write_group(thing: Any, name: str, weights: np.ndarray) -> Iterator[None]:
    """Gives an object a group, with weights as read_groups() gives them."""
    group = thing.vertex_groups.get(name) or thing.vertex_groups.new(name=name)
    members = np.flatnonzero(np.isfinite(weights))
    for begin in range(0, len(members), BLOCK):
        here = members[begin : begin + BLOCK]
        values, which = np.unique(weights[here], return_inverse=True)
        here = here[np.argsort(which, kind="stable")]
        ends = np.cumsum(np.bincount(which, minlength=len(values)))
        first = done = 0
        for value, end in zip(values.tolist(), ends.tolist()):
            group.add(here[first:end].tolist(), value, "REPLACE")
            done += 1 + (end - first) // 50
            first = end
            if done > CHUNK:
                done = 0
                yield
        yield


def carry_keys(source: Any, target: Any, of: layers.Maps, co: np.ndarray) -> Iterator[None]:
    """Gives the object `target`, whose vertices are at `co`, the shape keys of the mesh `source`.

    A key moves an output vertex as it moves the place that it comes from; where the vertex is one
    of the source, unmoved, it has the key's own bits.
    """
    keys = source.shape_keys
    if keys is None:
        return
    rest = layers.get(source.vertices, "co", np.float32, 3)
    near = of.nearest
    still = of.whole & (co == rest[near]).all(axis=1)
    yield
    for block in keys.key_blocks:
        places = layers.get(block.data, "co", np.float32, 3)
        yield
        moved = co + (yield from layers.taken(of, places.astype(np.float64) - rest))
        values = np.where(still[:, None], places[near], moved).astype(np.float32)
        yield
        new = target.shape_key_add(name=block.name, from_mix=False)
        layers.put(new.data, "co", values)
        for name in ("interpolation", "mute", "slider_min", "slider_max", "vertex_group"):
            setattr(new, name, getattr(block, name))
        new.value = block.value
        yield
    made = target.data.shape_keys
    made.use_relative = keys.use_relative
    for block, new in zip(keys.key_blocks, made.key_blocks):
        if block.relative_key is not None:
            new.relative_key = made.key_blocks[block.relative_key.name]
    if keys.animation_data is not None:
        animation = made.animation_data_create()
        animation.action = keys.animation_data.action
        own_action(animation)
        for driver in keys.animation_data.drivers:
            animation.drivers.from_existing(src_driver=driver)


def own_action(animation: Any) -> None:
    """An action that others have too becomes one of its own."""
    if animation.action is not None and animation.action.users > 1:
        animation.action = animation.action.copy()
