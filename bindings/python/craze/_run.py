"""Runs: a mesh and a recipe in, a Result out."""

from __future__ import annotations

import copy
import math
import os
from typing import Any, Iterable, Mapping

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._library import PIXEL_TYPES, Error, Handle, address, call, listed, real, shown, text_bytes
from ._library import text_of, whole
from ._lines import Lines
from ._maps import Maps, green_up, maps_of, name_list
from ._mesh import Mesh
from ._recipe import set_job, value_text
from ._watch import ProgressCallback, check_progress, run, watched


class Result:
    """A finished run. Everything is computed when asked for; nothing is cracked again.

    Several threads may use one Result: they take turns.
    """

    def __init__(self, job: Handle, progress: ProgressCallback | None) -> None:
        self._job = job
        self._progress = progress
        self._mesh: Mesh | None = None
        self._lines: Lines | None = None
        self._report: dict[str, Any] | None = None
        self._summary: dict[str, Any] = text_of(call("craze_job_summary", job.pointer))
        self._opening: tuple[bytes, Handle] | None = None

    def __repr__(self) -> str:
        cracks = self._summary["cracks"]
        return f"<craze.Result: {cracks['events']} cracks, {cracks['fragments']} fragments>"

    @property
    def mesh(self) -> Mesh:
        """The cut mesh, shut. vertex_attributes hold crack_distance, crack_time, crack_growth and
        displacement, face_attributes fragment and source_face, beside those of the input."""
        if self._mesh is None:
            self._mesh = Mesh._of(self._product("craze_job_cut_mesh", "craze_mesh_free"))
        return self._mesh

    @property
    def lines(self) -> Lines:
        """The cracks as lines."""
        if self._lines is None:
            self._lines = Lines(self._product("craze_job_lines", "craze_lines_free"))
        return self._lines

    @property
    def report(self) -> dict[str, Any]:
        """What was done: recipe, seed, counts, times, why it stopped, statistics."""
        if self._report is None:
            self._report = run(self._job, self._progress, "craze_job_report", take=text_of)
        report: dict[str, Any] = self._report
        return report

    @property
    def recipe(self) -> dict[str, Any]:
        """The whole recipe of the run, seed included, as crack() takes it: lengths are numbers, in
        model units, and post.gap is what a gap_width came to."""
        recipe: dict[str, Any] = copy.deepcopy(self._summary["recipe"])
        return recipe

    def stats(self) -> dict[str, Any]:
        """The statistics of the pattern; {} where nothing cracked."""
        result: dict[str, Any] = run(
            self._job, self._progress, "craze_job_statistics", take=text_of
        )
        return result

    def opened(
        self,
        gap: float | None = None,
        wall: float | str | None = None,
        curl: float | None = None,
        thickness: float | str | None = None,
        core: bool | None = None,
        **post: Any,
    ) -> Mesh:
        """The mesh with its cracks open; what is not given is the recipe's [post].

        gap : times the displacement ([IO06 Eq. 9]); wall : depth of side walls, length; curl :
        lift of the edges over their displacement; thickness : each fragment is a closed solid so
        deep, instead of walls; 0: none; core : what is left inside a closed surface is one too;
        post : any other key of [post], such as roughness, relative_roughness or late_width.
        Lengths are numbers, in model units, or texts with a unit: "2%", "3mm". Raises Error.
        """
        opening = self._open(gap, wall, curl, thickness, core, post)
        return Mesh._of(Handle(call("craze_opening_mesh", opening.pointer), "craze_mesh_free"))

    def warnings(
        self,
        gap: float | None = None,
        wall: float | str | None = None,
        curl: float | None = None,
        thickness: float | str | None = None,
        core: bool | None = None,
        **post: Any,
    ) -> list[str]:
        """What could not be done as asked, in the run and in the opening, a sentence each."""
        opening = self._open(gap, wall, curl, thickness, core, post)
        return [*self._summary["warnings"], *listed("craze_opening_warning", opening.pointer)]

    def with_post(
        self,
        gap: float | None = None,
        wall: float | str | None = None,
        curl: float | None = None,
        thickness: float | str | None = None,
        core: bool | None = None,
        **post: Any,
    ) -> Result:
        """This run as it would be had its recipe said so, arguments as of opened(): for its lines,
        maps, statistics, report and file. Nothing is cracked again. Raises Error."""
        text = _post_text(gap, wall, curl, thickness, core, post)
        job = self._product("craze_job_with_post", "craze_job_free", text)
        return Result(job, self._progress)

    def positions_at(
        self,
        t: float,
        gap: float | None = None,
        wall: float | str | None = None,
        curl: float | None = None,
        thickness: float | str | None = None,
        core: bool | None = None,
        **post: Any,
    ) -> npt.NDArray[np.float64]:
        """(n, 3): the vertices of opened() with the same arguments at a time of the growth, from 0,
        no crack, to 1, all of them. Raises Error."""
        time = real(t, "time")
        opening = self._open(gap, wall, curl, thickness, core, post)
        positions = np.empty((call("craze_opening_vertex_count", opening.pointer), 3))

        def move(_: Any) -> None:
            call("craze_opening_positions_at", opening.pointer, time, address(positions))

        watched(move, lock=opening.lock)
        return positions

    def fragments(self, thickness: float | str | None = None, core: bool | None = None) -> list[Mesh]:
        """The parts of `mesh`, in the order of its face attribute `fragment`. With a thickness,
        given here or by the recipe, they are closed solids, their cracks as open as the recipe
        says, and a core is the last of them. Raises Error."""
        given = self._summary["recipe"]["post"]["thickness"] if thickness is None else thickness
        if not isinstance(given, str) and real(given, "thickness") == 0:
            return self.mesh.fragments()
        return self.opened(thickness=thickness, core=core).fragments()

    def bake(
        self,
        size: int = 1024,
        maps: Iterable[str] | None = None,
        green: str = "up",
        gap: float | None = None,
        wall: float | None = None,
    ) -> Maps:
        """Maps of the cracks for the mesh's own UVs, size × size texels, the first row that of the
        top (v = 1): (size, size) or (size, size, 3).

        maps : names of docs/maps.md, such as ["mask", "normal"]; all where none are given
        green : "up" or "down" with v, of normals
        gap, wall : width of the grooves over the cracks' opening, and their depth; the recipe's,
            as curl and late width are

        Keys are the names; "SET_mask" where the materials need a texture set each, "mask.1001" where
        the UVs have tiles. Raises Error, also where the mesh has no UVs. What could not be done as
        asked is a UserWarning.
        """
        post = self._summary["recipe"]["post"]
        handle = self._product(
            "craze_job_bake",
            "craze_maps_free",
            whole(size, "size", 1, 8192),
            name_list(maps),
            green_up(green),
            real(post["gap"] if gap is None else gap, "gap"),
            real(post["wall"] if wall is None else wall, "wall"),
        )
        return maps_of(handle)

    def write(self, path: str | bytes | os.PathLike[Any]) -> None:
        """Writes the mesh, opened as the recipe's [post] says: .ply .obj .stl .glb .usda, the same
        bytes as the command's. See Mesh.write."""
        self.opened().write(path)

    def _product(self, name: str, free: str, *arguments: Any) -> Handle:
        handle: Handle = run(
            self._job, self._progress, name, *arguments, take=lambda pointer: Handle(pointer, free)
        )
        return handle

    def _open(
        self,
        gap: float | None,
        wall: float | str | None,
        curl: float | None,
        thickness: float | str | None,
        core: bool | None,
        others: Mapping[str, Any],
    ) -> Handle:
        text = _post_text(gap, wall, curl, thickness, core, others)
        kept = self._opening
        if kept is None or kept[0] != text:
            kept = (text, self._product("craze_job_open_post", "craze_opening_free", text))
            self._opening = kept
        return kept[1]


def _post_text(
    gap: float | None,
    wall: float | str | None,
    curl: float | None,
    thickness: float | str | None,
    core: bool | None,
    others: Mapping[str, Any],
) -> bytes:
    """What is given of [post], as craze.h takes it."""
    post = dict(others)
    for name, value in (("gap", gap), ("wall", wall), ("curl", curl), ("thickness", thickness)):
        if value is None:
            continue
        if isinstance(value, str) and name in ("wall", "thickness"):
            post[name] = value  # a length with a unit
            continue
        post[name] = real(value, name)
        if not math.isfinite(post[name]):
            raise Error(f"wrong {name} ({shown(value)}): must be finite", "request")
    if core is not None:
        post["core"] = bool(core)
    return value_text("the opening", {"post": post})


def _set_texture(job: Handle, name: str, picture: Any) -> None:
    what = f"texture {name}"
    pixels = _arrays.pixels(picture, what)
    height, width, channels = pixels.shape
    call(
        "craze_job_set_texture",
        job.pointer,
        text_bytes(name, "name of a texture"),
        address(pixels),
        PIXEL_TYPES[pixels.dtype],
        width,
        height,
        channels,
    )


def _mesh_of(mesh: Any) -> Mesh:
    if isinstance(mesh, Mesh):
        return mesh
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return Mesh(*mesh)
    raise Error(f"wrong mesh ({shown(mesh)}): must be a craze.Mesh or (vertices, faces)")


def crack(
    mesh: Mesh | tuple[npt.ArrayLike, npt.ArrayLike],
    recipe: str | os.PathLike[Any] | Mapping[str, Any] = "glaze",
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
    progress : progress(phase, fraction, cracks, load), about twenty times a second, in the thread
        that calls crack(), and for what is asked of the Result later; fraction is 0 … 1, or None
        where no end is known. What it raises stops the run and comes out of it
    settings : keys of the recipe: crack(m, "mud", **{"layer.spacing": 0.2})

    Raises Error where the mesh or recipe cannot be used. Ctrl-C stops it. Other threads run
    meanwhile.
    """
    check_progress(progress)
    given = _mesh_of(mesh)
    job = Handle(call("craze_job_new"), "craze_job_free")
    source = given._as_handle()
    call("craze_job_set_mesh", job.pointer, source.pointer)
    for name, picture in given.textures.items():
        _set_texture(job, name, picture)
    set_job(job, recipe, settings, seed, threads)
    if max_cracks is not None:
        most = whole(max_cracks, "max_cracks", 0, 2**63 - 1)
        call("craze_job_set_max_cracks", job.pointer, most)
    del source  # the job has the mesh, and lets go of it where nobody else has it
    run(job, progress, "craze_job_run")
    return Result(job, progress)
