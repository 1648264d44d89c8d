"""Materials as assets: marks, catalogues, files of a library."""

from __future__ import annotations

import os
import uuid
from typing import Any

import bpy
import numpy as np

from .work import Problem

CATALOGUES = "blender_assets.cats.txt"  # as Blender calls it, in the root of a library
_HEAD = """# This is an Asset Catalog Definition file for Blender.
#
# Empty lines and lines starting with `#` will be ignored.
# The first non-ignored line should be the version indicator.
# Other lines are of the format "UUID:catalog/path/for/assets:simple catalog name"

VERSION 1
"""


def catalogue(path: str) -> str:
    """By which Blender knows the catalogue `path`, such as Craze/Mud, in every library."""
    return str(uuid.uuid5(uuid.NAMESPACE_URL, f"craze:{path}"))


def mark(thing: Any, path: str, tags: list[str], text: str, preview: np.ndarray) -> None:
    """Makes a data-block an asset in a catalogue; preview (n, n, 3), sRGB, the first row on top."""
    thing.asset_mark()
    about = thing.asset_data
    about.catalog_id = catalogue(path)
    about.description = text
    for tag in tags:
        about.tags.new(tag, skip_if_exists=True)
    rows, columns, _ = preview.shape
    pixels = np.ones((rows, columns, 4), np.float32)
    pixels[:, :, :3] = preview[::-1]
    shown = thing.preview_ensure()
    shown.image_size = columns, rows
    shown.image_pixels_float.foreach_set(pixels.reshape(-1))


def write(thing: Any, folder: str, path: str) -> str:
    """Writes an asset as FOLDER/its name.blend, a file that is not there yet, and its catalogue to
    the folder's own list; returns the file's path."""
    try:
        os.makedirs(folder, exist_ok=True)
        _add_catalogue(os.path.join(folder, CATALOGUES), path)
    except OSError as e:
        raise Problem(f"{e.filename}: {e.strerror}") from None
    name = bpy.path.clean_name(thing.name)
    file, number = os.path.join(folder, f"{name}.blend"), 1
    while os.path.exists(file):
        number += 1
        file = os.path.join(folder, f"{name} {number}.blend")
    try:
        bpy.data.libraries.write(file, {thing}, fake_user=True)
    except (OSError, RuntimeError) as e:
        raise Problem(f"{file} cannot be written: {e}") from None
    return file


def _add_catalogue(file: str, path: str) -> None:
    """Adds a line to a list of catalogues, whole or not at all; lines that are there stay."""
    text = _HEAD
    if os.path.exists(file):
        with open(file, encoding="utf-8") as old:
            text = old.read()
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    if not lines or lines[0].split() != ["VERSION", "1"]:
        raise Problem(f"{file} is of a version that is not known")
    name = catalogue(path)
    if any(line.split(":")[0] == name for line in lines):
        return
    if not text.endswith("\n"):
        text += "\n"
    part = f"{file}.part"
    with open(part, "w", encoding="utf-8") as new:
        new.write(f"{text}{name}:{path}:{path.replace('/', '-')}\n")
    os.replace(part, file)
