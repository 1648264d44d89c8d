"""Baked maps as images of Blender's."""

from __future__ import annotations

from typing import Any

import bpy

UDIM = "<UDIM>"
COLOURS = {"base_color"}  # maps whose numbers are light, linear; those of others are no colours


def load(files: list[dict[str, Any]], name: str, pack: bool) -> dict[tuple[str, str], Any]:
    """{(texture set, map): image} of what worker/runs.py wrote; the tiles of a map are one image.
    Names of images begin with `name`; packed ones are in the .blend."""
    sheets: dict[tuple[str, str], list[dict[str, Any]]] = {}
    for file in files:
        sheets.setdefault((file["set"], file["map"]), []).append(file)
    return {key: _image(tiles, name, pack) for key, tiles in sheets.items()}


def _image(tiles: list[dict[str, Any]], name: str, pack: bool) -> Any:
    first = tiles[0]
    image = bpy.data.images.load(first["file"], check_existing=True)
    image.name = " ".join(filter(None, (name, first["set"], first["map"])))
    if first["map"] not in COLOURS:
        image.colorspace_settings.name = "Non-Color"
    if first["tile"]:
        _tile(image, first, {tile["tile"] for tile in tiles})
    image.reload()
    if pack:
        image.pack()
    elif bpy.data.is_saved and bpy.context.preferences.filepaths.use_relative_paths:
        image.filepath = bpy.path.relpath(image.filepath)
    return image


def _tile(image: Any, first: dict[str, Any], wanted: set[int]) -> None:
    image.source = "TILED"
    image.filepath = first["file"].replace(f".{first['tile']}.", f".{UDIM}.")
    for number in wanted - {tile.number for tile in image.tiles}:
        image.tiles.new(tile_number=number)
    for tile in [t for t in image.tiles if t.number not in wanted]:
        image.tiles.remove(tile)
