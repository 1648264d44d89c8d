"""Runs: a mesh and a recipe in, a Result out."""

from __future__ import annotations

import ctypes
import json
import os
from typing import Any, Callable, Mapping

import numpy as np

from ._library import PROGRESS, Cancelled, Error, Handle, address, call, call_json, view
from ._mesh import Mesh

ProgressCallback = Callable[[str, "float | None", int, float], object]


class Lines:
    """The cracks as a graph on the surface; edges meet only at points.

    Attributes
    ----------
    points : (p, 3) float64
    edges : (e, 2) int32, indices of points; the crack grew from the first to the second
    time : (e,) float64, the load at which each edge opened
    width : (e,) float64, length, the opening of [IO06 Eq. 9] with γ = 1
    event : (e,) float64, the number of the crack, from 0
    junction : (p,) float64, 0 end, 1 bend, 2 junction, 3 on the border
    normal : (p, 3) float64, unit, of the surface
    """

    def __init__(self, pointer: int) -> None:
        handle = Handle(pointer, "craze_lines_free")

        def get(name: str) -> np.ndarray:
            return view(handle, "craze_lines_array", name)

        self.points: np.ndarray = get("points")
        self.edges: np.ndarray = get("edges")
        self.time: np.ndarray = get("edge:time")[:, 0]
        self.width: np.ndarray = get("edge:width")[:, 0]
        self.event: np.ndarray = get("edge:event")[:, 0]
        self.junction: np.ndarray = get("point:junction")[:, 0]
        self.normal: np.ndarray = get("point:normal")

    def __repr__(self) -> str:
        return f"<craze.Lines of {len(self.points)} points, {len(self.edges)} edges>"


class _Callback:
    """A progress function of the user's as C calls it; what it raises stops the run."""

    def __init__(self, job: Handle, progress: ProgressCallback | None) -> None:
        self.raised: BaseException | None = None

        def ask(_: Any, phase: bytes, fraction: float, cracks: int, load: float) -> int:
            # Ctrl-C is raised here too: Python looks for signals while it runs this.
            try:
                if self.raised is None and progress is not None:
                    progress(phase.decode(), None if fraction < 0 else fraction, cracks, load)
            except BaseException as e:  # noqa: BLE001 - it is raised again once C has returned
                self.raised = e
            return 0 if self.raised is None else 1

        self._ask = PROGRESS(ask)
        self._job = job
        call("craze_job_set_progress", job.pointer, self._ask, None)

    def run(self, name: str, *arguments: Any) -> Any:
        """Calls a function of craze.h that may call back."""
        self.raised = None
        try:
            result = call(name, self._job.pointer, *arguments)
        except Cancelled:
            raise self.raised if self.raised is not None else KeyboardInterrupt() from None
        if self.raised is not None:  # too late to stop anything
            raise self.raised
        return result


class Result:
    """A finished run. Everything is computed when asked for; nothing is cracked again."""

    def __init__(self, job: Handle, callback: _Callback) -> None:
        self._job = job
        self._callback = callback
        self._mesh: Mesh | None = None
        self._lines: Lines | None = None
        self._report: dict[str, Any] | None = None
        self._opening: tuple[tuple[float, float, float], Handle] | None = None

    def __repr__(self) -> str:
        cracks = self.report["cracks"]
        return f"<craze.Result: {cracks['events']} cracks, {cracks['fragments']} fragments>"

    @property
    def mesh(self) -> Mesh:
        """The cut mesh, shut. vertex_attributes hold crack_distance, crack_time, crack_growth and
        displacement, face_attributes fragment and source_face, beside those of the input."""
        if self._mesh is None:
            self._mesh = Mesh._from_pointer(self._callback.run("craze_job_cut_mesh"))
        return self._mesh

    @property
    def lines(self) -> Lines:
        """The cracks as lines."""
        if self._lines is None:
            self._lines = Lines(self._callback.run("craze_job_lines"))
        return self._lines

    @property
    def report(self) -> dict[str, Any]:
        """What was done: recipe, seed, counts, times, why it stopped, statistics."""
        if self._report is None:
            self._report = call_json("craze_job_report", self._job.pointer)
        assert self._report is not None
        return self._report

    def stats(self) -> dict[str, Any]:
        """The statistics of the pattern; {} where nothing cracked."""
        result: dict[str, Any] = call_json("craze_job_statistics", self._job.pointer)
        return result

    def _open(self, gap: float | None, wall: float | None, curl: float | None) -> Handle:
        post = self.report["recipe"]["post"]
        key = tuple(
            float(post[name] if given is None else given)
            for name, given in (("gap", gap), ("wall", wall), ("curl", curl))
        )
        if self._opening is None or self._opening[0] != key:
            pointer = self._callback.run("craze_job_open", *key)
            self._opening = (key, Handle(pointer, "craze_opening_free"))  # type: ignore[assignment]
        assert self._opening is not None
        return self._opening[1]

    def opened(
        self, gap: float | None = None, wall: float | None = None, curl: float | None = None
    ) -> Mesh:
        """The mesh with its cracks open; what is not given is the recipe's [post].

        gap : times the displacement ([IO06 Eq. 9]); wall : depth of side walls, length; curl :
        lift of the edges over their displacement. Raises Error.
        """
        return Mesh._from_pointer(
            call("craze_opening_mesh", self._open(gap, wall, curl).pointer)
        )

    def warnings(
        self, gap: float | None = None, wall: float | None = None, curl: float | None = None
    ) -> list[str]:
        """What could not be done as asked, in the run and in the opening, a sentence each."""
        found = list(self.report["warnings"])
        opening = self._open(gap, wall, curl)
        i = 0
        while (text := call("craze_opening_warning", opening.pointer, i)) is not None:
            found.append(text.decode())
            i += 1
        return found

    def positions_at(
        self,
        t: float,
        gap: float | None = None,
        wall: float | None = None,
        curl: float | None = None,
    ) -> np.ndarray:
        """(n, 3): the vertices of opened(gap, wall, curl) at a time of the growth, from 0, no
        crack, to 1, all of them. Raises Error."""
        opening = self._open(gap, wall, curl)
        mesh = Handle(call("craze_opening_mesh", opening.pointer), "craze_mesh_free")
        positions = np.empty(view(mesh, "craze_mesh_array", "vertices").shape)
        call("craze_opening_positions_at", opening.pointer, float(t), address(positions))
        return positions

    def fragments(self) -> list[Mesh]:
        """The parts of `mesh`, in the order of its face attribute `fragment`."""
        return self.mesh.fragments()

    def write(self, path: Any) -> None:
        """Writes the mesh, opened as the recipe's [post] says: .ply .obj .stl .glb."""
        self.opened().write(path)


def _value_text(key: str, value: Any) -> bytes:
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    try:
        return json.dumps(value, ensure_ascii=False, allow_nan=False).encode()
    except (TypeError, ValueError):
        raise Error(f"wrong type for {key} ({value!r}): a number, text or list is wanted") from None


def _set_recipe(job: Handle, recipe: Any) -> None:
    if isinstance(recipe, Mapping):
        text = _value_text("recipe", dict(recipe))
        call("craze_job_set_recipe", job.pointer, text, b"recipe")
        return
    name = os.fspath(recipe)
    if isinstance(name, bytes):
        name = os.fsdecode(name)
    if os.sep in name or name.endswith((".toml", ".json")):
        try:
            with open(name, "rb") as file:
                text = file.read()
        except OSError as e:
            raise Error(f"cannot read the recipe ({name}): {e.strerror}", "input") from None
        if b"\0" in text:
            raise Error(f"not a recipe ({name}): it holds a zero byte")
        call("craze_job_set_recipe", job.pointer, text, os.fsencode(name))
    else:
        call("craze_job_set_preset", job.pointer, name.encode())


def _set_texture(job: Handle, name: str, picture: Any) -> None:
    pixels = np.asarray(picture)
    if pixels.ndim != 2 or pixels.size == 0:
        raise Error(f"wrong texture {name} (shape {pixels.shape}): must be grey, (height, width)")
    scale = 1.0 / np.iinfo(pixels.dtype).max if pixels.dtype.kind == "u" else 1.0
    grey = np.ascontiguousarray(pixels * scale, np.float32)
    data = grey.ctypes.data_as(ctypes.POINTER(ctypes.c_float))
    height, width = grey.shape
    call("craze_job_set_texture", job.pointer, os.fsencode(name), data, width, height)


def crack(
    mesh: Mesh | tuple[Any, Any],
    recipe: str | os.PathLike[str] | Mapping[str, Any] = "glaze",
    seed: int | None = None,
    threads: int = 0,
    max_cracks: int | None = None,
    progress: ProgressCallback | None = None,
    **settings: Any,
) -> Result:
    """Cracks a mesh.

    Parameters
    ----------
    mesh : Mesh, or (vertices (n, 3), faces (m, 3)); any dtype and stride; not changed
    recipe : name of a preset, path of a .toml file, or a dict as presets() returns them
    seed : of the random numbers, instead of the recipe's; the same seed gives the same bytes
    threads : 0, one per core; the result does not depend on it
    max_cracks : stop after so many crack events; 0: before the first
    progress : progress(phase, fraction, cracks, load), about twenty times a second; fraction is
        0 … 1, or None where no end is known. What it raises stops the run and comes out of it
    settings : keys of the recipe: crack(m, "mud", **{"layer.spacing": 0.2})

    Raises Error where the mesh or recipe cannot be used. Ctrl-C stops it. Other threads run
    meanwhile.
    """
    given = mesh if isinstance(mesh, Mesh) else Mesh(*mesh)
    job = Handle(call("craze_job_new"), "craze_job_free")
    source = given._as_handle()
    call("craze_job_set_mesh", job.pointer, source.pointer)
    for name, picture in given.textures.items():
        _set_texture(job, name, picture)
    _set_recipe(job, recipe)
    for key, value in settings.items():
        call("craze_job_set", job.pointer, key.encode(), _value_text(key, value))
    if seed is not None:
        call("craze_job_set", job.pointer, b"seed", _value_text("seed", int(seed)))
    call("craze_job_set_threads", job.pointer, int(threads))
    if max_cracks is not None:
        if max_cracks < 0:
            raise Error(f"wrong number (max_cracks = {max_cracks}): must be 0 or more")
        call("craze_job_set_max_cracks", job.pointer, int(max_cracks))
    callback = _Callback(job, progress)
    callback.run("craze_job_run")
    return Result(job, callback)


def stats(
    points: Any, edges: Any, time: Any = None, simplify: float = 0.0
) -> dict[str, Any]:
    """Statistics of crack lines of any origin, such as the skeleton of a photograph.

    Parameters
    ----------
    points : (p, 3), or (p, 2) for lines in a plane
    edges : (e, 2) indices of points
    time : (e,), when each edge opened, or None
    simplify : lines are drawn by as few of their points as stay within this length of them; one
        pixel for a skeleton

    Raises Error for lines that are not in a plane: those of a Result know their surface, use its
    stats().
    """
    at = np.asarray(points, np.float64)
    if at.ndim == 2 and at.shape[1] == 2:
        at = np.column_stack([at, np.zeros(len(at))])
    if at.ndim != 2 or at.shape[1] != 3:
        raise Error(f"wrong points (shape {at.shape}): must be (p, 3) or (p, 2)")
    at = np.ascontiguousarray(at)
    ends = np.asarray(edges)
    if ends.size == 0:
        ends = ends.reshape(0, 2)
    if ends.ndim != 2 or ends.shape[1] != 2 or ends.dtype.kind not in "iuf":
        raise Error(f"wrong edges (shape {ends.shape}, {ends.dtype}): must be (e, 2) indices")
    if ends.size and (ends.min() < 0 or ends.max() >= len(at)):
        raise Error(f"wrong edges: must be indices of points, 0 to {len(at) - 1}")
    ends = np.ascontiguousarray(ends, np.int32)
    when = None
    if time is not None:
        when = np.ascontiguousarray(time, np.float64)
        if when.shape != (len(ends),):
            raise Error(f"wrong time (shape {when.shape}): must be ({len(ends)},)")
    result: dict[str, Any] = call_json(
        "craze_statistics",
        address(at),
        len(at),
        address(ends),
        len(ends),
        address(when) if when is not None else None,
        float(simplify),
    )
    return result
