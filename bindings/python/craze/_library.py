"""The C interface (craze.h) as Python calls it: argument types, errors, handles, views."""

from __future__ import annotations

import ctypes
import json
import operator
import os
import reprlib
import threading
from ctypes import POINTER, c_char_p, c_double, c_int, c_int32, c_int64, c_void_p
from typing import Any

import numpy as np
import numpy.typing as npt

INTERFACE = 1


class Error(Exception):
    """What went wrong, in one line: WHAT (WHERE): WHY.

    `kind` is "input", "usage", "request", "output", "memory" or "internal".
    """

    def __init__(self, message: str, kind: str = "usage") -> None:
        super().__init__(message)
        self.kind = kind


class Cancelled(Exception):
    """A callback asked to stop; never leaves the package."""


Array = npt.NDArray[Any]


class _CError(ctypes.Structure):
    _fields_ = [("status", c_int), ("message", ctypes.c_char * 1024)]


class CArray(ctypes.Structure):
    _fields_ = [("data", c_void_p), ("rows", c_int64), ("columns", c_int32), ("type", c_int)]


PROGRESS = ctypes.CFUNCTYPE(c_int, c_void_p, c_char_p, c_double, c_int64, c_double)
TOLD = ctypes.CFUNCTYPE(None, c_void_p, c_char_p)

_KINDS = {1: "input", 2: "usage", 3: "request", 4: "output", 6: "memory", 7: "internal"}
_CANCELLED = 5
_DTYPES = (np.dtype(np.float64), np.dtype(np.float32), np.dtype(np.int32))
PIXEL_TYPES = {np.dtype(np.uint8): 3, np.dtype(np.uint16): 4, np.dtype(np.float32): 1}

_ERROR = POINTER(_CError)
# name: (what it returns, what it takes before the error, whether it takes one).
_FUNCTIONS: dict[str, tuple[Any, list[Any], bool]] = {
    "craze_version": (c_char_p, [], False),
    "craze_interface": (c_int, [], False),
    "craze_text_free": (None, [c_void_p], False),
    "craze_presets": (c_void_p, [], True),
    "craze_parameters": (c_void_p, [], True),
    "craze_mesh_new": (c_void_p, [c_void_p, c_int64, c_void_p, c_int64], True),
    "craze_mesh_read": (c_void_p, [c_char_p, PROGRESS, c_void_p], True),
    "craze_mesh_warning": (c_char_p, [c_void_p, c_int64], False),
    "craze_mesh_shape": (c_void_p, [c_char_p], True),
    "craze_mesh_free": (None, [c_void_p], False),
    "craze_mesh_set": (c_int, [c_void_p, c_char_p, c_void_p, c_int64, c_int32], True),
    "craze_mesh_set_materials": (c_int, [c_void_p, c_void_p, POINTER(c_char_p), c_int64], True),
    "craze_mesh_array": (c_int, [c_void_p, c_char_p, POINTER(CArray)], True),
    "craze_mesh_array_name": (c_char_p, [c_void_p, c_int64], False),
    "craze_mesh_material_name": (c_char_p, [c_void_p, c_int64], False),
    "craze_mesh_write_telling": (c_int, [c_void_p, c_char_p, TOLD, PROGRESS, c_void_p], True),
    "craze_mesh_keep_origin": (c_int, [c_void_p, c_void_p], False),
    "craze_mesh_fragment_count": (c_int64, [c_void_p], True),
    "craze_mesh_fragments": (c_int, [c_void_p, POINTER(c_void_p), c_int64], True),
    "craze_mesh_mass": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p], True),
    "craze_mesh_convex_hull": (c_void_p, [c_void_p], True),
    "craze_job_new": (c_void_p, [], False),
    "craze_job_free": (None, [c_void_p], False),
    "craze_job_set_mesh": (c_int, [c_void_p, c_void_p], True),
    "craze_job_set_texture": (
        c_int,
        [c_void_p, c_char_p, c_void_p, c_int, c_int64, c_int64, c_int32],
        True,
    ),
    "craze_job_set_preset": (c_int, [c_void_p, c_char_p], True),
    "craze_job_set_recipe": (c_int, [c_void_p, c_char_p, c_char_p], True),
    "craze_job_set": (c_int, [c_void_p, c_char_p, c_char_p], True),
    "craze_job_recipe": (c_void_p, [c_void_p], True),
    "craze_job_set_threads": (c_int, [c_void_p, c_int], True),
    "craze_job_set_max_cracks": (c_int, [c_void_p, c_int64], True),
    "craze_job_set_progress": (None, [c_void_p, PROGRESS, c_void_p], False),
    "craze_job_run": (c_int, [c_void_p], True),
    "craze_job_cut_mesh": (c_void_p, [c_void_p], True),
    "craze_job_lines": (c_void_p, [c_void_p], True),
    "craze_lines_array": (c_int, [c_void_p, c_char_p, POINTER(CArray)], True),
    "craze_lines_free": (None, [c_void_p], False),
    "craze_job_report": (c_void_p, [c_void_p], True),
    "craze_job_summary": (c_void_p, [c_void_p], True),
    "craze_job_statistics": (c_void_p, [c_void_p], True),
    "craze_statistics": (
        c_void_p,
        [c_void_p, c_int64, c_void_p, c_int64, c_void_p, c_double],
        True,
    ),
    "craze_job_open_post": (c_void_p, [c_void_p, c_char_p], True),
    "craze_job_with_post": (c_void_p, [c_void_p, c_char_p], True),
    "craze_job_bake": (c_void_p, [c_void_p, c_int32, c_char_p, c_int32, c_double, c_double], True),
    "craze_job_texture": (c_void_p, [c_void_p, c_char_p, c_int32, c_char_p, c_int32], True),
    "craze_maps_free": (None, [c_void_p], False),
    "craze_maps_name": (c_char_p, [c_void_p, c_int64], False),
    "craze_maps_array": (c_int, [c_void_p, c_int64, POINTER(CArray)], True),
    "craze_maps_description": (c_char_p, [c_void_p], False),
    "craze_maps_warning": (c_char_p, [c_void_p, c_int64], False),
    "craze_opening_free": (None, [c_void_p], False),
    "craze_opening_mesh": (c_void_p, [c_void_p], True),
    "craze_opening_warning": (c_char_p, [c_void_p, c_int64], False),
    "craze_opening_vertex_count": (c_int64, [c_void_p], False),
    "craze_opening_positions_at": (c_int, [c_void_p, c_double, c_void_p], True),
}


def _load() -> ctypes.CDLL:
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), "libcraze.so")
    loaded = ctypes.CDLL(beside if os.path.exists(beside) else "libcraze.so.0")
    loaded.craze_interface.restype = c_int
    if loaded.craze_interface() != INTERFACE:
        raise ImportError(
            f"libcraze has interface {loaded.craze_interface()}, this package needs {INTERFACE}"
        )
    for name, (result, arguments, fails) in _FUNCTIONS.items():
        function = getattr(loaded, name)
        function.restype = result
        function.argtypes = arguments + ([_ERROR] if fails else [])
    return loaded


_loaded = _load()


def call(name: str, *arguments: Any) -> Any:
    """Calls a function of craze.h; raises Error or Cancelled where it fails."""
    function = getattr(_loaded, name)
    if not _FUNCTIONS[name][2]:
        return function(*arguments)
    error = _CError()
    result = function(*arguments, ctypes.byref(error))
    if error.status == _CANCELLED:
        raise Cancelled()
    if error.status != 0:
        message = error.message.decode("utf-8", "replace")
        raise Error(message, _KINDS.get(error.status, "internal"))
    return result


def text_of(pointer: int) -> Any:
    """The value of a JSON text that craze.h returned, which it frees."""
    try:
        return json.loads(ctypes.string_at(pointer).decode("utf-8"))
    finally:
        call("craze_text_free", pointer)


def listed(name: str, pointer: int) -> list[str]:
    """What a function of craze.h says for i = 0, 1, … until it has no more."""
    texts: list[str] = []
    while (text := call(name, pointer, len(texts))) is not None:
        texts.append(text.decode("utf-8", "replace"))
    return texts


class Handle:
    """Owns what a function of craze.h returned and frees it once nobody looks at it any more."""

    def __init__(self, pointer: int, free: str) -> None:
        self.pointer = pointer
        self.lock = threading.Lock()  # held by whoever is at work on it
        self._free = getattr(_loaded, free)

    def __reduce__(self) -> Any:
        raise TypeError("a run lives in its process: copy or pickle its meshes, lines and report")

    def __del__(self) -> None:
        pointer, self.pointer = getattr(self, "pointer", 0), 0
        if pointer:
            self._free(pointer)


class _View:
    """Memory of a handle, which it keeps alive, in NumPy's array interface."""

    def __init__(self, handle: Handle, array: CArray) -> None:
        self.handle = handle
        self.__array_interface__ = {
            "version": 3,
            "shape": (array.rows, array.columns),
            "typestr": _DTYPES[array.type].str,
            "data": (array.data, True),
        }


def view(handle: Handle, array_of: str, name: str) -> Array:
    """A read-only view (rows, columns) of a handle's array; nothing is copied."""
    array = CArray()
    call(array_of, handle.pointer, name.encode(), ctypes.byref(array))
    if array.rows == 0 or not array.data:
        nothing = np.empty((array.rows, array.columns), _DTYPES[array.type])
        nothing.flags.writeable = False
        return nothing
    return np.asarray(_View(handle, array))


def address(array: Array) -> int:
    """Of the first number; the array must be contiguous and outlive the call."""
    return int(array.ctypes.data)


def path_bytes(path: Any) -> bytes:
    """A path of any kind as the C interface takes it."""
    try:
        name = os.fsencode(path)
    except (TypeError, ValueError):
        raise Error(f"wrong path ({shown(path)}): must be a text or path") from None
    if b"\0" in name:
        raise Error(f"wrong path ({shown(path)}): it holds a zero byte")
    return name


def text_bytes(text: Any, what: str) -> bytes:
    """A text as the C interface takes it."""
    if isinstance(text, str) and "\0" not in text:
        try:
            return text.encode()
        except UnicodeEncodeError:
            pass
    raise Error(f"wrong {what} ({shown(text)}): must be a text, without zero bytes")


def whole(value: Any, what: str, low: int, high: int) -> int:
    """A whole number of any type; floats are none."""
    try:
        number = operator.index(value)
    except TypeError:
        number = low - 1
    if not low <= number <= high:
        raise Error(f"wrong {what} ({shown(value)}): must be a whole number in [{low}, {high}]")
    return number


def real(value: Any, what: str) -> float:
    """A number of any type."""
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise Error(f"wrong {what} ({shown(value)}): must be a number") from None


def shown(value: Any) -> str:
    """Any value in a few words, for messages."""
    return reprlib.repr(value)
