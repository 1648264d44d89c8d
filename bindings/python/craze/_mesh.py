"""Meshes: arrays of the user's, files, built-in shapes, and what comes out of a run."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from ._library import Error, Handle, address, call, path_bytes, view


def _rows(values: Any, columns: int, what: str) -> np.ndarray:
    array = np.asarray(values)
    if array.size == 0:
        array = array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns or array.dtype.kind not in "biuf":
        raise Error(f"wrong {what} (shape {array.shape}, {array.dtype}): must be (n, {columns}) numbers")
    return array


def _vertices(values: Any) -> np.ndarray:
    return np.ascontiguousarray(_rows(values, 3, "vertices"), np.float64)


def _faces(values: Any, vertices: int) -> np.ndarray:
    faces = _rows(values, 3, "faces")
    if faces.dtype.kind not in "biu":
        if not np.array_equal(faces, np.trunc(faces)):
            raise Error("wrong faces (not whole numbers): must be vertex indices")
    if faces.size and (faces.min() < 0 or faces.max() >= vertices):
        raise Error(
            f"wrong faces ({int(faces.min())} to {int(faces.max())}): "
            f"must be vertex indices, 0 to {vertices - 1}"
        )
    return np.ascontiguousarray(faces, np.int32)


def _corner_uv(uv: Any, faces: np.ndarray, vertices: int) -> np.ndarray:
    """(m, 3, 2) of UVs per corner, or per vertex."""
    array = np.asarray(uv, np.float64)
    count = len(faces)
    if array.shape == (count, 3, 2):
        return np.ascontiguousarray(array)
    if array.shape == (vertices, 2):
        return np.ascontiguousarray(array[faces])
    if array.shape == (3 * count, 2):
        return np.ascontiguousarray(array.reshape(count, 3, 2))
    raise Error(
        f"wrong uv (shape {array.shape}): must be ({count}, 3, 2), one per corner of each face, "
        f"or ({vertices}, 2), one per vertex"
    )


class Mesh:
    """Triangles with attributes.

    Order is kept: vertex i and face f are those of the arrays or the file that it was made of.

    Attributes
    ----------
    vertices : (n, 3) float64, in the unit of the mesh
    faces : (m, 3) int32, vertex indices, counter-clockwise seen from outside
    uv : (m, 3, 2) float64, per corner of each face, or None
    vertex_attributes : {name: (n,) or (n, k) array}
    face_attributes : {name: (m,) or (m, k) array}
    textures : {name: (height, width) array}, grey pictures that a recipe names, row 0 on top,
        0 … 1, or 0 … 255 for uint8

    Arrays that craze made are read-only; assign a new one to change it.
    """

    def __init__(
        self,
        vertices: Any,
        faces: Any,
        uv: Any = None,
        vertex_attributes: Mapping[str, Any] | None = None,
        face_attributes: Mapping[str, Any] | None = None,
        textures: Mapping[str, Any] | None = None,
    ) -> None:
        """Any dtype and stride. `uv` per corner, (m, 3, 2), or per vertex, (n, 2).

        Raises Error for shapes that do not fit and indices that are not vertices.
        """
        self.vertices: np.ndarray = _vertices(vertices)
        self.faces: np.ndarray = _faces(faces, len(self.vertices))
        self.uv: np.ndarray | None = (
            None if uv is None else _corner_uv(uv, self.faces, len(self.vertices))
        )
        self.vertex_attributes: dict[str, Any] = dict(vertex_attributes or {})
        self.face_attributes: dict[str, Any] = dict(face_attributes or {})
        self.textures: dict[str, Any] = dict(textures or {})
        self._handle: Handle | None = None
        self._made_of: tuple[Any, ...] = ()

    def __repr__(self) -> str:
        return f"<craze.Mesh of {len(self.vertices)} vertices, {len(self.faces)} faces>"

    @classmethod
    def _from_pointer(cls, pointer: int) -> Mesh:
        handle = Handle(pointer, "craze_mesh_free")
        mesh = cls.__new__(cls)
        mesh.uv = None
        mesh.vertex_attributes, mesh.face_attributes, mesh.textures = {}, {}, {}
        i = 0
        while (name := call("craze_mesh_array_name", pointer, i)) is not None:
            i += 1
            text = name.decode()
            array = view(handle, "craze_mesh_array", text)
            if text == "vertices":
                mesh.vertices = array
            elif text == "faces":
                mesh.faces = array
            elif text == "uv":
                mesh.uv = array.reshape(-1, 3, 2)
            elif text == "colors":
                mesh.vertex_attributes["color"] = array
            elif text == "materials":
                mesh.face_attributes["material"] = array[:, 0]
            elif text.startswith("vertex:"):
                mesh.vertex_attributes[text[7:]] = array[:, 0] if array.shape[1] == 1 else array
            elif text.startswith("face:"):
                mesh.face_attributes[text[5:]] = array[:, 0] if array.shape[1] == 1 else array
        mesh._handle = handle
        mesh._made_of = mesh._state()
        return mesh

    def _state(self) -> tuple[Any, ...]:
        """What a handle was made of: as long as it is the same, the handle stands for the mesh."""
        return (
            id(self.vertices),
            id(self.faces),
            id(self.uv),
            tuple((k, id(v)) for k, v in self.vertex_attributes.items()),
            tuple((k, id(v)) for k, v in self.face_attributes.items()),
        )

    def _as_handle(self) -> Handle:
        """For the C interface. Arrays of the user's may have been written to, so they are taken
        anew each time."""
        untouched = self._handle is not None and self._made_of == self._state()
        if self._handle is not None and untouched:
            return self._handle
        vertices = _vertices(self.vertices)
        faces = _faces(self.faces, len(vertices))
        pointer = call(
            "craze_mesh_new", address(vertices), len(vertices), address(faces), len(faces)
        )
        handle = Handle(pointer, "craze_mesh_free")
        if self.uv is not None:
            _set(handle, "uv", _corner_uv(self.uv, faces, len(vertices)).reshape(-1, 2))
        for name, values in self.vertex_attributes.items():
            _set(handle, f"vertex:{name}", _attribute(values, len(vertices), name))
        for name, values in self.face_attributes.items():
            _set(handle, f"face:{name}", _attribute(values, len(faces), name))
        return handle

    def write(self, path: Any) -> None:
        """Writes .ply, .obj, .stl or .glb: the whole file or none. Raises Error."""
        call("craze_mesh_write", self._as_handle().pointer, path_bytes(path))

    def fragments(self) -> list[Mesh]:
        """The parts by the face attribute `fragment`, in order. Raises Error where there is none."""
        import ctypes

        handle = self._as_handle()
        count = call("craze_mesh_fragment_count", handle.pointer)
        pointers = (ctypes.c_void_p * count)()
        call("craze_mesh_fragments", handle.pointer, pointers, count)
        return [Mesh._from_pointer(p) for p in pointers if p is not None]


def _attribute(values: Any, rows: int, name: str) -> np.ndarray:
    array = np.asarray(values)
    if array.ndim == 1:
        array = array.reshape(-1, 1)
    if array.ndim != 2 or len(array) != rows or array.dtype.kind not in "biuf":
        raise Error(
            f"wrong attribute {name} (shape {array.shape}, {array.dtype}): "
            f"must be ({rows},) or ({rows}, k) numbers"
        )
    return np.ascontiguousarray(array, np.float64)


def _set(handle: Handle, name: str, values: np.ndarray) -> None:
    call(
        "craze_mesh_set",
        handle.pointer,
        name.encode(),
        address(values),
        values.shape[0],
        values.shape[1],
    )


def read(path: Any) -> Mesh:
    """A mesh from a file: .obj .ply .stl .off .gltf .glb. Raises Error."""
    return Mesh._from_pointer(call("craze_mesh_read", path_bytes(path)))


def shape(specification: str) -> Mesh:
    """A built-in shape: "plate?n=60&jitter=0.3", "cup", "sphere?n=40" … Raises Error."""
    return Mesh._from_pointer(call("craze_mesh_shape", specification.encode()))
