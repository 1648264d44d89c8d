"""Meshes: arrays of the user's, files, built-in shapes, and what comes out of a run."""

from __future__ import annotations

import ctypes
import os
import warnings
from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._library import TOLD, Array, Handle, address, call, listed, path_bytes, text_bytes, view
from ._watch import watched


class Mesh:
    """Triangles with attributes.

    Order is kept: vertex i and face f are those of the arrays or the file that it was made of.

    Attributes
    ----------
    vertices : (n, 3) float64, in the unit of the mesh
    faces : (m, 3) int32, vertex indices, counter-clockwise seen from outside
    uv : (m, 3, 2) float64, per corner of each face, or None
    normals : (m, 3, 3) float64, unit, per corner of each face, or None
    vertex_attributes : {name: (n,) or (n, k) array}; "color" is linear RGBA, 0 … 1
    face_attributes : {name: (m,) or (m, k) array}; "material" counts material_names, −1: none
    material_names : names of the materials
    textures : {name: (height, width) or (height, width, channels) array}, pictures that a recipe
        names, row 0 on top: uint8, uint16, or floats in 0 … 1. Colours count by their luminance
    warnings : what was left out of the file that it was read from, a sentence each

    Arrays that craze made are read-only, and views of its memory: assign a new array to change
    one. Arrays of yours that have the dtype above are used as they are, not copied; what you write
    to them counts from the next run on.
    """

    def __init__(
        self,
        vertices: npt.ArrayLike,
        faces: npt.ArrayLike,
        uv: npt.ArrayLike | None = None,
        vertex_attributes: Mapping[str, npt.ArrayLike] | None = None,
        face_attributes: Mapping[str, npt.ArrayLike] | None = None,
        textures: Mapping[str, npt.ArrayLike] | None = None,
    ) -> None:
        """Any dtype and stride. `uv` per corner, (m, 3, 2), or per vertex, (n, 2).

        Raises Error for shapes that do not fit and indices that are not vertices.
        """
        self.vertices: npt.NDArray[np.float64] = _arrays.points(vertices, "vertices")
        count = len(self.vertices)
        self.faces: npt.NDArray[np.int32] = _arrays.indices(faces, 3, count, "faces")
        self.uv: npt.NDArray[np.float64] | None = (
            None if uv is None else _arrays.corners(uv, 2, self.faces, count, "uv")
        )
        self.normals: npt.NDArray[np.float64] | None = None
        self.vertex_attributes: dict[str, Any] = dict(vertex_attributes or {})
        self.face_attributes: dict[str, Any] = dict(face_attributes or {})
        self.material_names: list[str] = []
        self.textures: dict[str, Any] = dict(textures or {})
        self.warnings: list[str] = []
        self._source_faces: Array | None = None  # the polygon of the file of each face
        self._handle: Handle | None = None
        self._made_of: list[Any] = []

    def __repr__(self) -> str:
        return f"<craze.Mesh of {len(self.vertices)} vertices, {len(self.faces)} faces>"

    def __getstate__(self) -> dict[str, Any]:
        """Copies and pickles have the arrays, and make a handle of their own."""
        return {**self.__dict__, "_handle": None, "_made_of": []}

    @classmethod
    def _of(cls, handle: Handle) -> Mesh:
        arrays = {
            name: view(handle, "craze_mesh_array", name)
            for name in listed("craze_mesh_array_name", handle.pointer)
        }
        mesh = cls(arrays.pop("vertices"), arrays.pop("faces"))
        if "uv" in arrays:
            mesh.uv = arrays["uv"].reshape(-1, 3, 2)
        if "normals" in arrays:
            mesh.normals = arrays["normals"].reshape(-1, 3, 3)
        if "colors" in arrays:
            mesh.vertex_attributes["color"] = arrays["colors"]
        if "materials" in arrays:
            mesh.face_attributes["material"] = arrays["materials"][:, 0]
        if "source_faces" in arrays:
            mesh._source_faces = arrays["source_faces"]
        for name, array in arrays.items():
            kind, _, own = name.partition(":")
            if own:
                of = mesh.vertex_attributes if kind == "vertex" else mesh.face_attributes
                of[own] = array[:, 0] if array.shape[1] == 1 else array
        mesh.material_names = listed("craze_mesh_material_name", handle.pointer)
        mesh.warnings = listed("craze_mesh_warning", handle.pointer)
        mesh._handle = handle
        mesh._made_of = mesh._parts()
        return mesh

    def _parts(self) -> list[Any]:
        """What a handle is made of."""
        parts: list[Any] = [self.vertices, self.faces, self.uv, self.normals]
        for attributes in (self.vertex_attributes, self.face_attributes):
            parts.append(len(attributes))
            for name, values in attributes.items():
                parts += [name, values]
        return parts + self.material_names

    def _as_handle(self) -> Handle:
        """For the C interface: that of its own as long as it has the same arrays, which are
        read-only then; arrays of the user's are taken anew each time."""
        if self._handle is not None:
            parts = self._parts()
            same = len(parts) == len(self._made_of) and all(
                a is b or (isinstance(a, (str, int)) and a == b)
                for a, b in zip(parts, self._made_of)
            )
            if same:
                return self._handle
        return self._new_handle()

    def _new_handle(self) -> Handle:
        vertices = _arrays.points(self.vertices, "vertices")
        n = len(vertices)
        faces = _arrays.indices(self.faces, 3, n, "faces")
        m = len(faces)
        handle = Handle(
            call("craze_mesh_new", address(vertices), n, address(faces), m), "craze_mesh_free"
        )

        def set_array(name: str, values: Array) -> None:
            count, columns = values.shape
            key = text_bytes(name, "attribute")
            call("craze_mesh_set", handle.pointer, key, address(values), count, columns)

        if self.uv is not None:
            set_array("uv", _arrays.corners(self.uv, 2, faces, n, "uv").reshape(-1, 2))
        if self.normals is not None:
            normals = _arrays.corners(self.normals, 3, faces, n, "normals")
            set_array("normals", normals.reshape(-1, 3))
        if self._source_faces is not None and len(self._source_faces) == m:
            set_array("source_faces", np.ascontiguousarray(self._source_faces, np.float64))
        for name, values in self.vertex_attributes.items():
            set_array(f"vertex:{name}", _arrays.attribute(values, n, f"attribute {name}"))
        for name, values in self.face_attributes.items():
            if name == "material" and self.material_names:
                _set_materials(handle, values, m, self.material_names)
            else:
                set_array(f"face:{name}", _arrays.attribute(values, m, f"attribute {name}"))
        if self._handle is not None:
            call("craze_mesh_keep_origin", handle.pointer, self._handle.pointer)
        return handle

    def write(self, path: str | bytes | os.PathLike[Any]) -> None:
        """Writes .ply, .obj, .stl, .glb or .usda: the whole file or none. Raises Error.

        A mesh that was read, and what crack() makes of it, is written with all that its file held
        besides, as the command does it: nodes, materials, textures, animations … So it is after
        vertices have been moved and attributes added, but not once faces, UVs, normals, colours or
        other attributes that it had are replaced, nor of copies. What the format has no place for
        is said by a UserWarning.
        """
        handle, name = self._as_handle(), path_bytes(path)
        lost: list[str] = []
        told = TOLD(lambda _, sentence: lost.append(sentence.decode("utf-8", "replace")))
        watched(
            lambda callback: call(
                "craze_mesh_write_telling", handle.pointer, name, told, callback, None
            ),
            finish=True,
        )
        for sentence in lost:
            warnings.warn(sentence, UserWarning, stacklevel=2)

    def fragments(self) -> list[Mesh]:
        """The parts by the face attribute `fragment`, in order. Raises Error where there is none."""
        handle = self._as_handle()

        def cut(_: Any) -> list[Handle]:
            count = call("craze_mesh_fragment_count", handle.pointer)
            pointers = (ctypes.c_void_p * count)()
            call("craze_mesh_fragments", handle.pointer, pointers, count)
            return [Handle(p, "craze_mesh_free") for p in pointers if p]

        return [Mesh._of(piece) for piece in watched(cut)]

    def mass_properties(self) -> dict[str, Any]:
        """Of a closed mesh, density 1: `volume`, `centre` of mass (3,) and `inertia` (3, 3) about
        it. The volume is below 0 where the faces look inwards. Raises Error."""
        volume, centre, inertia = np.empty(1), np.empty(3), np.empty((3, 3))
        call(
            "craze_mesh_mass",
            self._as_handle().pointer,
            address(volume),
            address(centre),
            address(inertia),
        )
        return {"volume": float(volume[0]), "centre": centre, "inertia": inertia}

    def convex_hull(self) -> Mesh:
        """The convex hull of the vertices, of at most 64 of them: a collider for a physics engine.
        It has no faces where all lie in a plane. Raises Error."""
        hull = call("craze_mesh_convex_hull", self._as_handle().pointer)
        return Mesh._of(Handle(hull, "craze_mesh_free"))


def _set_materials(handle: Handle, values: Any, faces: int, names: list[str]) -> None:
    column = _arrays.attribute(values, faces, "attribute material")
    indices = _arrays.indices(column + 1, 1, len(names) + 1, "attribute material") - np.int32(1)
    texts = [text_bytes(name, "name of a material") for name in names]
    call(
        "craze_mesh_set_materials",
        handle.pointer,
        address(indices),
        (ctypes.c_char_p * len(texts))(*texts),
        len(texts),
    )


def read(path: str | bytes | os.PathLike[Any]) -> Mesh:
    """A mesh from a file: .obj .ply .stl .off .gltf .glb. Raises Error."""
    name = path_bytes(path)
    return Mesh._of(
        watched(lambda ask: Handle(call("craze_mesh_read", name, ask, None), "craze_mesh_free"))
    )


def shape(specification: str) -> Mesh:
    """A built-in shape: "plate?n=60&jitter=0.3", "cup", "sphere?n=40" … Raises Error."""
    text = text_bytes(specification, "shape")
    return Mesh._of(watched(lambda _: Handle(call("craze_mesh_shape", text), "craze_mesh_free")))
