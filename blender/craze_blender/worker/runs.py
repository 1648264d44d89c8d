"""Finished runs that are kept, and what is made of them as arrays for Blender."""

from __future__ import annotations

import os
import re
import warnings
from collections import OrderedDict
from contextlib import contextmanager, nullcontext
from typing import Any, Callable, Iterator

import numpy as np
from carry import Carried, Source, carry
from exr import write_exr
from preview import tile_preview

import craze

KEPT = 3  # runs; an older one is cracked anew when somebody asks for it
REST, ORIGIN = "craze.rest", "craze.origin"  # attributes that say where a vertex, a face was
OURS = ("crack_distance", "crack_time", "crack_growth")
TILE_MAPS = ("base_color", "normal", "height", "occlusion", "roughness")
MAP_NAME = re.compile(r"(?:(?P<set>.+)_)??(?P<map>base_color|[a-z]+)(?:\.(?P<tile>\d{4}))?")


class Run:
    """A mesh of Blender's and the Result of cracking it."""

    def __init__(self, arrays: Any, names: dict[str, Any]) -> None:
        self.stretch = arrays["stretch"].astype(np.float64)
        self.local = arrays["vertices"]  # (n, 3) float32, as Blender has them
        self.source = Source(
            places=self.local.astype(np.float64) @ self.stretch,
            edges=arrays["edges"],
            loop_vertex=arrays["loop_vertex"],
            loop_start=arrays["loop_start"],
            loop_total=arrays["loop_total"],
            triangles=arrays["triangles"],
            triangle_polygon=arrays["triangle_polygon"],
        )
        self.mesh = self._mesh(arrays, names)
        self.result: craze.Result | None = None

    def _mesh(self, arrays: Any, names: dict[str, Any]) -> craze.Mesh:
        source = self.source
        faces = source.loop_vertex[source.triangles]
        uv = arrays["uv"][source.triangles] if "uv" in arrays else None
        mesh = craze.Mesh(source.places, faces, uv=uv)
        for name in names["attributes"]:
            mesh.vertex_attributes[name] = arrays["attribute " + name]
        for name in names["pictures"]:
            mesh.textures[name] = arrays["picture " + name]
        if names["materials"]:
            # An empty slot is a material too: faces of two slots are told apart.
            mesh.material_names = names["materials"]
            mesh.face_attributes["material"] = arrays["material"][source.triangle_polygon]
        mesh.vertex_attributes[REST] = source.places
        mesh.face_attributes[ORIGIN] = np.arange(len(faces))
        return mesh

    def crack(self, recipe: Any, settings: dict[str, Any], progress: Callable[..., None]) -> None:
        self.result = craze.crack(self.mesh, recipe, progress=progress, **settings)

    def opened(self, post: dict[str, Any]) -> dict[str, np.ndarray]:
        """The mesh, its cracks open, as Blender takes it."""
        assert self.result is not None
        mesh = self.result.opened(**post)
        face_source = np.asarray(mesh.face_attributes["source_face"])
        origin = np.rint(np.asarray(mesh.face_attributes[ORIGIN])).astype(np.int64)
        walls = face_source < 0
        carried = carry(
            self.source, mesh.faces, np.asarray(mesh.vertex_attributes[REST]), origin, walls
        )
        arrays = {name: getattr(carried, name) for name in Carried.__dataclass_fields__}
        triangle = arrays.pop("triangle")
        arrays["co"] = self._to_local(mesh.vertices, carried)
        for name in OURS:
            arrays["point " + name] = np.asarray(mesh.vertex_attributes[name], np.float32)
        arrays["point displacement"] = self._turned_back(mesh.vertex_attributes["displacement"])
        arrays["face fragment"] = np.asarray(mesh.face_attributes["fragment"]).astype(np.int32)[
            triangle
        ]
        if post.get("thickness", 0) > 0:
            arrays["solids"] = self._solids(mesh)
        return _with_loose(self.source, self.local, arrays)

    def report(self, post: dict[str, Any]) -> dict[str, Any]:
        """That of the run with `post`, of which rough cracks are longer, for one. In its recipe a
        gap width is a gap, "1%" a number."""
        assert self.result is not None
        said: dict[str, Any] = self.result.with_post(**post).report
        return said

    def _solids(self, mesh: craze.Mesh) -> np.ndarray:
        """(k, 4) of each fragment: its volume in the scene's unit, its centre of mass in the
        object's axes."""
        mass = [piece.mass_properties() for piece in mesh.fragments()]
        volume = np.array([[m["volume"]] for m in mass])
        return np.hstack([volume, self._turned_back(np.array([m["centre"] for m in mass]))])

    def positions(self, times: list[float], post: dict[str, Any]) -> dict[str, np.ndarray]:
        """{"grown 000": …} each (n, 3) float32: vertices of opened(post) at times of the growth,
        0 … 1."""
        assert self.result is not None
        return {
            f"grown {i:03}": self._turned_back(self.result.positions_at(t, **post))
            for i, t in enumerate(times)
        }

    def lines(self, post: dict[str, Any]) -> dict[str, np.ndarray]:
        assert self.result is not None
        lines = self.result.with_post(**post).lines
        return {
            "points": self._turned_back(lines.points),
            "normal": np.asarray(lines.normal, np.float32),
            "edges": np.asarray(lines.edges, np.int32),
            "time": np.asarray(lines.time, np.float32),
            "width": np.asarray(lines.width, np.float32),
            "event": np.asarray(lines.event).astype(np.int32),
        }

    def bake(
        self, size: int, maps: list[str] | None, post: dict[str, Any], folder: str,
        progress: Callable[..., None],
    ) -> dict[str, Any]:  # fmt: skip
        """Writes maps (docs/maps.md) of the active UV map to `folder`. Says of each of `files` its
        path, the `map`, its texture `set`, "" where there is one, the UDIM `tile`, 0 without, and
        the `largest` of its numbers; the `sets` that materials have by their index; `warnings`."""
        assert self.result is not None
        with _heard() as said:
            baked = self.result.with_post(**post).bake(size, maps)
        files = _written(baked, folder, progress)
        sets = list(dict.fromkeys(file["set"] for file in files if file["set"]))
        return {"files": files, "sets": self._by_material(sets), "warnings": said}

    def _by_material(self, sets: list[str]) -> dict[int, str]:
        """Sets come in the order of the materials that faces have, one for each name."""
        assert self.result is not None
        mesh = self.result.mesh
        if not sets:
            return {}
        used = np.unique(np.asarray(mesh.face_attributes["material"], np.int64))
        names = dict.fromkeys(mesh.material_names[i] for i in used)
        of_name = dict(zip(names, sets))
        return {int(i): of_name[mesh.material_names[i]] for i in used}

    def _turned_back(self, places: Any) -> np.ndarray:
        """(n, 3) float32: from the engine's axes to those of the object."""
        if (self.stretch == np.eye(3)).all():
            return np.asarray(places, np.float32)
        return np.asarray(np.linalg.solve(self.stretch, np.asarray(places).T).T, np.float32)

    def _to_local(self, places: Any, carried: Carried) -> np.ndarray:
        """As _turned_back; what did not move has the bits that it had."""
        local = self._turned_back(places)
        corner = carried.point_weight.max(axis=1) == 1.0
        of = np.take_along_axis(
            carried.point_source, carried.point_weight.argmax(axis=1)[:, None], axis=1
        )[:, 0]
        still = corner & (np.asarray(places) == self.source.places[of]).all(axis=1)
        local[still] = self.local[of[still]]
        return local


@contextmanager
def _heard() -> Iterator[list[str]]:
    """What the engine warns of meanwhile, in the list once that ends."""
    sentences: list[str] = []
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        yield sentences
    sentences += [str(w.message) for w in said]


def _written(
    maps: craze.Maps, folder: str, progress: Callable[..., None]
) -> list[dict[str, Any]]:
    """Writes maps to files, maps.json last, and says of each what bake() says; takes them out of
    the dict."""
    os.makedirs(folder, exist_ok=True)
    files: list[dict[str, Any]] = []
    for name in list(maps):
        progress("write", len(files) / (len(files) + len(maps)), 0, 0.0)
        values, part = maps.pop(name), MAP_NAME.fullmatch(name)
        assert part is not None
        path = os.path.join(folder, f"{name}.exr")
        write_exr(path, values)
        files.append(
            {
                "file": path,
                "map": part["map"],
                "set": part["set"] or "",
                "tile": int(part["tile"] or 0),
                "largest": float(values.max()),
            }
        )
    with open(os.path.join(folder, "maps.json"), "w", encoding="utf-8") as file:
        file.write(maps.description)
    return files


def _with_loose(
    source: Source, local: np.ndarray, arrays: dict[str, np.ndarray]
) -> dict[str, np.ndarray]:
    """Adds the vertices and edges that no face has, which the engine does not see."""
    used = np.zeros(len(local), bool)
    used[source.loop_vertex] = True
    lone = np.flatnonzero(~used)
    following = np.arange(1, len(source.loop_vertex) + 1)
    ends = source.loop_start + source.loop_total - 1
    following[ends] = source.loop_start
    a, b = source.loop_vertex, source.loop_vertex[following]
    of_faces = np.minimum(a, b).astype(np.int64) << 32 | np.maximum(a, b)
    low, high = source.edges.min(axis=1), source.edges.max(axis=1)
    wires = np.flatnonzero(~np.isin(low.astype(np.int64) << 32 | high, of_faces))
    if not len(lone) and not len(wires):
        return arrays
    vertices = len(arrays["co"])
    new = np.full(len(local), -1, np.int64)
    at = arrays["point_weight"].argmax(axis=1)
    corner = np.flatnonzero(arrays["point_weight"].max(axis=1) == 1.0)[::-1]
    new[arrays["point_source"][corner, at[corner]]] = corner
    new[lone] = vertices + np.arange(len(lone))
    ends = new[source.edges[wires]]
    wires, ends = wires[(ends >= 0).all(axis=1)], ends[(ends >= 0).all(axis=1)]
    unit = np.tile([1.0, 0.0, 0.0], (len(lone), 1))
    more = {
        "co": local[lone],
        "point_source": np.repeat(lone[:, None], 3, axis=1).astype(np.int32),
        "point_weight": unit,
        "point crack_time": np.full(len(lone), -1, np.float32),
        "point crack_growth": np.full(len(lone), -1, np.float32),
        "edges": ends.astype(np.int32),
        "edge_source": wires.astype(np.int32),
    }
    for name, values in arrays.items():
        if name in more:
            arrays[name] = np.concatenate([values, more[name]])
        elif name.startswith("point "):
            none = np.zeros((len(lone), *values.shape[1:]), values.dtype)
            arrays[name] = np.concatenate([values, none])
    return arrays


class Runs:
    """What a worker does: a method per request, taking its fields and giving those of the reply."""

    def __init__(self) -> None:
        self._kept: OrderedDict[str, Run] = OrderedDict()

    def crack(
        self, run: str, mesh: str, names: dict[str, Any], recipe: Any, is_text: bool,
        settings: dict[str, Any], post: dict[str, Any], out: str, progress: Callable[..., None],
    ) -> dict[str, Any]:  # fmt: skip
        """Cracks the mesh in the file `mesh` and keeps it as `run`; then as open()."""
        with np.load(mesh) as arrays:
            new = Run({name: arrays[name] for name in arrays.files}, names)
        os.remove(mesh)
        with _as_file(recipe, os.path.dirname(out)) if is_text else nullcontext(recipe) as given:
            new.crack(given, settings, progress)
        self._kept[run] = new
        while len(self._kept) > KEPT:
            self._kept.popitem(last=False)
        return self.open(run, post, out, progress)

    def open(
        self, run: str, post: dict[str, Any], out: str, progress: Callable[..., None]
    ) -> dict[str, Any]:
        """Writes the opened mesh to the file `out` and gives the `report` of the run so opened;
        {"lost": true} where the run is not kept."""
        made = self._made(run, out, lambda kept: kept.opened(post), post)
        return made if made.get("lost") else {**made, "report": self._kept[run].report(post)}

    def grow(
        self, run: str, times: list[float], post: dict[str, Any], out: str,
        progress: Callable[..., None],
    ) -> dict[str, Any]:  # fmt: skip
        """As open(), with positions at some times."""
        made = self._made(
            run, out, lambda kept: {**kept.opened(post), **kept.positions(times, post)}, post
        )
        return made if made.get("lost") else {**made, "report": self._kept[run].report(post)}

    def lines(
        self, run: str, post: dict[str, Any], out: str, progress: Callable[..., None]
    ) -> dict[str, Any]:
        """Writes the cracks as lines to the file `out`."""
        return self._made(run, out, lambda kept: kept.lines(post), post)

    def bake(
        self, run: str, size: int, maps: list[str] | None, post: dict[str, Any], folder: str,
        out: str, progress: Callable[..., None],
    ) -> dict[str, Any]:  # fmt: skip
        """Writes maps to `folder`; {"lost": true} where the run is not kept."""
        kept = self._find(run)
        if kept is None:
            return {"lost": True}
        return kept.bake(size, maps, post, folder, progress)

    def texture(
        self, recipe: Any, is_text: bool, settings: dict[str, Any], size: int, period: float,
        folder: str, out: str, progress: Callable[..., None],
    ) -> dict[str, Any]:  # fmt: skip
        """Writes the maps of a tile to `folder` and a preview to the file `out`."""
        with _as_file(recipe, os.path.dirname(out)) if is_text else nullcontext(recipe) as given:
            with _heard() as said:
                maps = craze.texture(
                    given, size, period, list(TILE_MAPS), progress=progress, **settings
                )
        np.savez(out, preview=tile_preview(maps))
        files = _written(maps, folder, progress)
        return {"file": out, "files": files, "warnings": said}

    def hello(self, progress: Callable[..., None]) -> dict[str, Any]:
        return {"version": craze.__version__}

    def _find(self, run: str) -> Run | None:
        """The last one that somebody asked for is the last one to go."""
        kept = self._kept.get(run)
        if kept is not None:
            self._kept.move_to_end(run)
        return kept

    def _made(
        self,
        run: str,
        out: str,
        make: Callable[[Run], dict[str, np.ndarray]],
        post: dict[str, Any] | None = None,
    ) -> dict[str, Any]:
        kept = self._find(run)
        if kept is None:
            return {"lost": True}
        np.savez(out, **make(kept))
        assert kept.result is not None
        return {"file": out, "warnings": kept.result.warnings(**(post or {}))}


@contextmanager
def _as_file(text: str, folder: str) -> Iterator[str]:
    """The path of a file that holds the text of a recipe; errors call it "recipe"."""
    path = os.path.join(folder, "recipe.toml")
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        yield path
    except craze.Error as e:
        raise craze.Error(str(e).replace(path, "recipe"), e.kind) from None
    finally:
        os.remove(path)
