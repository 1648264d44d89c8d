"""Pictures of numbers as OpenEXR files, as the command's --map-format exr writes them.

Format: OpenEXR file layout, openexr.com/en/latest/OpenEXRFileLayout.html: one part of scan lines, ZIP
in blocks of 16.
"""

from __future__ import annotations

import os
import struct
import zlib
from typing import Any

import numpy as np

ROWS = 16  # of a block
MAGIC, VERSION, FLOAT, ZIP = 20000630, 2, 2, 3


def write_exr(path: str, values: Any) -> None:
    """(h, w) as channel Y, or (h, w, 3) as R, G, B, float32; row 0 on top. The file gets its place
    when it is whole."""
    pixels = np.asarray(values, "<f4")
    pixels = pixels.reshape(*pixels.shape[:2], -1)
    height = len(pixels)
    blocks = [_packed(pixels[y : y + ROWS]) for y in range(0, height, ROWS)]
    head = _header(*pixels.shape)
    sizes = [8 + len(block) for block in blocks]
    first = len(head) + 8 * len(blocks)
    offsets = first + np.cumsum([0, *sizes[:-1]], dtype="<u8")
    part = path + ".part"
    try:
        with open(part, "wb") as file:
            file.write(head + offsets.tobytes())
            for i, block in enumerate(blocks):
                file.write(struct.pack("<ii", ROWS * i, len(block)) + block)
        os.replace(part, path)
    finally:
        if os.path.exists(part):
            os.remove(part)


def _packed(rows: np.ndarray) -> bytes:
    """Channels of a row one after the other by their names; even bytes first, then odd ones, as
    differences."""
    plain = np.ascontiguousarray(rows[:, :, ::-1].transpose(0, 2, 1)).tobytes()
    apart = np.frombuffer(plain[0::2] + plain[1::2], np.uint8)
    steps = apart.copy()
    steps[1:] = apart[1:] - apart[:-1] + np.uint8(128)
    stream = zlib.compressobj(1, zlib.DEFLATED, zlib.MAX_WBITS, 9)
    packed = stream.compress(steps.tobytes()) + stream.flush()
    return packed if len(packed) < len(plain) else plain


def _header(height: int, width: int, channels: int) -> bytes:
    listed = b"".join(
        name + b"\0" + struct.pack("<4I", FLOAT, 0, 1, 1)
        for name in ((b"B", b"G", b"R") if channels == 3 else (b"Y",))
    )
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    attributes = (
        (b"channels", b"chlist", listed + b"\0"),
        (b"compression", b"compression", bytes([ZIP])),
        (b"dataWindow", b"box2i", window),
        (b"displayWindow", b"box2i", window),
        (b"lineOrder", b"lineOrder", b"\0"),
        (b"pixelAspectRatio", b"float", struct.pack("<f", 1)),
        (b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0)),
        (b"screenWindowWidth", b"float", struct.pack("<f", 1)),
    )
    head = struct.pack("<2I", MAGIC, VERSION)
    for name, kind, value in attributes:
        head += name + b"\0" + kind + b"\0" + struct.pack("<I", len(value)) + value
    return head + b"\0"
