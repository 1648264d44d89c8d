"""What users give as arrays, checked and in the layout that the C interface takes."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._library import PIXEL_TYPES, Array, Error


def numbers(values: Any, what: str) -> Array:
    """Real numbers of any dtype and stride, with nothing masked."""
    try:
        array = np.asanyarray(values)
    except (TypeError, ValueError) as e:
        raise Error(f"wrong {what}: not an array of numbers: {e}") from None
    if np.ma.is_masked(array):  # type: ignore[no-untyped-call]
        raise Error(f"wrong {what}: some numbers are masked; fill or drop them first")
    if array.dtype.kind not in "biuf":
        raise Error(f"wrong {what} ({array.dtype}): must be numbers")
    return np.asarray(array)


def rows(values: Any, columns: int, what: str) -> Array:
    """(n, columns) numbers; nothing at all is no rows."""
    array = numbers(values, what)
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns:
        raise Error(f"wrong {what} (shape {array.shape}): must be (n, {columns})")
    return array


def points(values: Any, what: str) -> Array:
    """(n, 3) float64, contiguous; the array itself where it is that already."""
    return np.ascontiguousarray(rows(values, 3, what), np.float64)


def indices(values: Any, columns: int, count: int, what: str) -> Array:
    """(m, columns) int32, contiguous, each 0 … count − 1; the array itself where it is that."""
    array = rows(values, columns, what)
    if array.dtype.kind == "f" and not np.array_equal(array, np.trunc(array)):
        raise Error(f"wrong {what}: not whole numbers")
    if array.dtype.kind == "b":
        raise Error(f"wrong {what} (bool): must be indices")
    if array.size and (array.min() < 0 or array.max() >= count):
        raise Error(
            f"wrong {what} ({array.min()} to {array.max()}): "
            f"must be indices, from 0 to {count - 1}"
        )
    return np.ascontiguousarray(array, np.int32)


def attribute(values: Any, count: int, what: str) -> Array:
    """(count, k) float64, contiguous, of (count,) or (count, k) numbers."""
    array = numbers(values, what)
    if array.ndim == 1:
        array = array.reshape(-1, 1)
    if array.ndim != 2 or len(array) != count or array.shape[1] == 0:
        raise Error(f"wrong {what} (shape {array.shape}): must be ({count},) or ({count}, k)")
    return np.ascontiguousarray(array, np.float64)


def corners(values: Any, columns: int, faces: Array, vertices: int, what: str) -> Array:
    """(m, 3, columns) float64, contiguous, of values per corner or per vertex."""
    array = numbers(values, what)
    count = len(faces)
    if array.shape == (count, 3, columns):
        pass
    elif array.shape == (3 * count, columns):
        array = array.reshape(count, 3, columns)
    elif array.shape == (vertices, columns):
        array = array[faces]
    else:
        raise Error(
            f"wrong {what} (shape {array.shape}): must be ({count}, 3, {columns}), one per corner "
            f"of each face, or ({vertices}, {columns}), one per vertex"
        )
    return np.ascontiguousarray(array, np.float64)


def pixels(values: Any, what: str) -> Array:
    """(height, width, channels) uint8, uint16 or float32, contiguous."""
    array = numbers(values, what)
    if array.ndim == 2:
        array = array[:, :, np.newaxis]
    if array.ndim != 3 or array.size == 0 or array.shape[2] > 4:
        raise Error(
            f"wrong {what} (shape {array.shape}): must be (height, width), or with up to 4 channels"
        )
    native = array.dtype.newbyteorder("=")
    if native not in PIXEL_TYPES and array.dtype.kind not in "bf":
        raise Error(f"wrong {what} ({array.dtype}): must be uint8, uint16, or floats in 0 … 1")
    return np.ascontiguousarray(array, native if native in PIXEL_TYPES else np.float32)
