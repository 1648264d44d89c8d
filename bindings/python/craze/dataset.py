"""Datasets that `craze dataset` made, as arrays. Needs NumPy alone.

    for sample in craze.dataset.samples("pavement"):
        train(sample["image"], sample["mask"] > 0)
"""

from __future__ import annotations

import json
import struct
import tarfile
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["read_cloud", "read_png", "samples"]


def read_png(data: bytes) -> NDArray[Any]:
    """The picture of a PNG as `craze dataset` writes it: (height, width) or (height, width, 3),
    uint8 or uint16. ValueError for PNGs of other makers that use what those do not."""
    at, packed, head = 8, [], b""
    while at < len(data):
        (length,) = struct.unpack(">I", data[at : at + 4])
        kind, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            head = body
        elif kind == b"IDAT":
            packed.append(body)
        at += length + 12
    width, height, bits, color, _, _, interlace = struct.unpack(">IIBBBBB", head)
    if bits not in (8, 16) or color not in (0, 2) or interlace:
        raise ValueError("not a PNG that craze dataset writes")
    channels, step = (3 if color == 2 else 1), bits // 8
    rows = np.frombuffer(zlib.decompress(b"".join(packed)), np.uint8).reshape(height, -1)
    if (rows[:, 0] != 1).any():  # every row: differences from the pixel on the left
        raise ValueError("not a PNG that craze dataset writes")
    pixels: NDArray[Any] = np.cumsum(
        rows[:, 1:].reshape(height, width, channels * step), axis=1, dtype=np.uint8
    )
    if step == 2:
        pixels = (pixels[..., 0::2].astype(np.uint16) << 8) | pixels[..., 1::2]
    return pixels.reshape((height, width) if channels == 1 else (height, width, 3))


def read_cloud(data: bytes) -> NDArray[Any]:
    """The points of a PLY as `craze dataset` writes it, as records: cloud["x"], cloud["crack"].
    ValueError for what others write that this does not read."""
    head, found, body = data.partition(b"end_header\n")
    lines = head.decode("ascii", "replace").splitlines()
    if not found or lines[:2] != ["ply", "format binary_little_endian 1.0"]:
        raise ValueError("not a PLY that craze dataset writes")
    types = {"double": "<f8", "float": "<f4", "int": "<i4", "uchar": "u1"}
    fields: list[tuple[str, str]] = []
    count = 0
    for words in (line.split() for line in lines[2:]):
        if words[:2] == ["element", "vertex"]:
            count = int(words[2])
        elif words[0] == "property" and words[1] in types:
            fields.append((words[2], types[words[1]]))
        elif words[0] != "comment":
            raise ValueError("not a PLY that craze dataset writes")
    return np.frombuffer(body, np.dtype(fields), count)


def samples(folder: str | Path) -> Iterator[dict[str, Any]]:
    """Each sample of the archives that are whole, in order: arrays "image", "mask", "coverage",
    "width", "distance", "depth" (pixels and model units), "normal", "crack", "fragment", where the
    plan asks for clouds "points" as records (read_cloud), and "json" as a dict. Only one sample is
    in memory. FileNotFoundError where there is no such set."""
    if not Path(folder, "shards").is_dir():
        raise FileNotFoundError(f"no dataset in {folder}: it has no folder shards")
    for marker in sorted(Path(folder, "shards").glob("[0-9]*.json")):
        if marker.name.endswith(".coco.json"):
            continue
        with tarfile.open(marker.with_suffix(".tar")) as tar:
            files: dict[str, bytes] = {}
            for entry in tar:
                kind = entry.name.split(".", 1)[1]
                content = tar.extractfile(entry)
                assert content is not None
                files[kind] = content.read()
                if kind == "json":
                    yield _sample(files)
                    files = {}


def _sample(files: dict[str, bytes]) -> dict[str, Any]:
    facts = json.loads(files["json"])
    label = facts["label"]
    sample: dict[str, Any] = {"json": facts}
    for kind, data in files.items():
        if kind.endswith(".png"):
            sample[kind[:-4]] = read_png(data)
        elif kind == "points.ply":
            sample["points"] = read_cloud(data)
    sample["coverage"] = sample["coverage"] / np.float32(255)
    sample["width"] = sample["width"] / np.float32(label["width_per_pixel"])
    sample["distance"] = sample["distance"] / np.float32(label["distance_per_pixel"])
    code, near, far = sample["depth"], label["depth_nearest"], label["depth_farthest"]
    depth = near + (code.astype(np.float64) - 1) / 65534 * (far - near)
    sample["depth"] = np.where(code > 0, depth, np.inf).astype(np.float32)
    normal = (sample["normal"].astype(np.float32) - 128) / 127
    sample["normal"] = np.where((sample["normal"] > 0).any(axis=2, keepdims=True), normal, 0)
    return sample
