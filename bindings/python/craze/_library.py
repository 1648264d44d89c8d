"""The C interface (craze.h) as Python calls it: argument types, errors, texts."""

from __future__ import annotations

import ctypes
import json
import os
from ctypes import POINTER, c_char_p, c_double, c_float, c_int, c_int32, c_int64, c_void_p
from typing import Any

import numpy as np

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


class _CError(ctypes.Structure):
    _fields_ = [("status", c_int), ("message", ctypes.c_char * 1024)]


class CArray(ctypes.Structure):
    _fields_ = [("data", c_void_p), ("rows", c_int64), ("columns", c_int32), ("type", c_int)]


PROGRESS = ctypes.CFUNCTYPE(c_int, c_void_p, c_char_p, c_double, c_int64, c_double)

_KINDS = {1: "input", 2: "usage", 3: "request", 4: "output", 6: "memory", 7: "internal"}
_CANCELLED = 5
_DTYPES = (np.float64, np.float32, np.int32)

_ERROR = POINTER(_CError)
# name: (what it returns, what it takes before the error); None as last: it takes no error.
_FUNCTIONS: dict[str, tuple[Any, list[Any], bool]] = {
    "craze_version": (c_char_p, [], False),
    "craze_interface": (c_int, [], False),
    "craze_text_free": (None, [c_void_p], False),
    "craze_presets": (c_void_p, [], True),
    "craze_parameters": (c_void_p, [], True),
    "craze_mesh_new": (c_void_p, [c_void_p, c_int64, c_void_p, c_int64], True),
    "craze_mesh_read": (c_void_p, [c_char_p], True),
    "craze_mesh_shape": (c_void_p, [c_char_p], True),
    "craze_mesh_free": (None, [c_void_p], False),
    "craze_mesh_set": (c_int, [c_void_p, c_char_p, c_void_p, c_int64, c_int32], True),
    "craze_mesh_array": (c_int, [c_void_p, c_char_p, POINTER(CArray)], True),
    "craze_mesh_array_name": (c_char_p, [c_void_p, c_int64], False),
    "craze_mesh_material_name": (c_char_p, [c_void_p, c_int64], False),
    "craze_mesh_write": (c_int, [c_void_p, c_char_p], True),
    "craze_mesh_fragment_count": (c_int64, [c_void_p], True),
    "craze_mesh_fragments": (c_int, [c_void_p, POINTER(c_void_p), c_int64], True),
    "craze_job_new": (c_void_p, [], False),
    "craze_job_free": (None, [c_void_p], False),
    "craze_job_set_mesh": (c_int, [c_void_p, c_void_p], True),
    "craze_job_set_texture": (c_int, [c_void_p, c_char_p, POINTER(c_float), c_int64, c_int64], True),
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
    "craze_job_statistics": (c_void_p, [c_void_p], True),
    "craze_statistics": (
        c_void_p,
        [c_void_p, c_int64, c_void_p, c_int64, c_void_p, c_double],
        True,
    ),
    "craze_job_open": (c_void_p, [c_void_p, c_double, c_double, c_double], True),
    "craze_opening_free": (None, [c_void_p], False),
    "craze_opening_mesh": (c_void_p, [c_void_p], True),
    "craze_opening_warning": (c_char_p, [c_void_p, c_int64], False),
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


def call_json(name: str, *arguments: Any) -> Any:
    """The same for functions that return JSON."""
    text = call(name, *arguments)
    try:
        value = ctypes.cast(text, c_char_p).value
        return json.loads(value.decode("utf-8")) if value is not None else None
    finally:
        call("craze_text_free", text)


class Handle:
    """Owns what a function of craze.h returned and frees it once nobody looks at it any more."""

    def __init__(self, pointer: int, free: str) -> None:
        self.pointer = pointer
        self._free = free

    def __del__(self) -> None:
        if getattr(self, "pointer", None):
            getattr(_loaded, self._free)(self.pointer)
            self.pointer = 0


class _View:
    """Memory of a handle, which it keeps alive, in NumPy's array interface."""

    def __init__(self, handle: Handle, array: CArray) -> None:
        self.handle = handle
        dtype = np.dtype(_DTYPES[array.type])
        self.__array_interface__ = {
            "version": 3,
            "shape": (array.rows, array.columns),
            "typestr": dtype.str,
            "data": (array.data, True),
        }


def view(handle: Handle, array_of: str, name: str) -> np.ndarray:
    """A read-only view (rows, columns) of a handle's array; nothing is copied."""
    array = CArray()
    call(array_of, handle.pointer, name.encode(), ctypes.byref(array))
    if array.rows == 0 or not array.data:
        return np.empty((array.rows, array.columns), _DTYPES[array.type])
    return np.asarray(_View(handle, array))


def address(array: np.ndarray) -> int:
    """Of the first number; the array must be contiguous and outlive the call."""
    return int(array.ctypes.data)


def path_bytes(path: Any) -> bytes:
    """A path of any kind as the C interface takes it."""
    name = os.fsencode(path)
    if b"\0" in name:
        raise Error(f"wrong path ({path!r}): it holds a zero byte", "usage")
    return name
