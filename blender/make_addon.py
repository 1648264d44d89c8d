"""make_addon.py PACKAGE VERSION FOLDER: the add-on as a folder and as a zip, both in FOLDER, and the
index that makes FOLDER a repository of extensions.

PACKAGE is the Python package craze with its libcraze.so; the add-on carries it, and its table of
parameters and presets as table.json. Needs Python 3.11 and NumPy. The same package gives the same bytes.
Prints the zip's path.
"""

from __future__ import annotations

import hashlib
import json
import re
import shutil
import sys
import tomllib
import zipfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parent / "craze_blender"
LICENSE = Path(__file__).resolve().parents[1] / "LICENSE"
FIRST_DATE = (1980, 1, 1, 0, 0, 0)  # of the zip format


def table_json(package: Path) -> str:
    """What the engine says of its parameters and presets."""
    sys.path.insert(0, str(package.parent))
    import craze
    from craze._library import call, text_of

    presets = text_of(call("craze_presets"))
    table = {
        "version": craze.__version__,
        "parameters": craze.parameters(),
        "presets": craze.presets(),
        "descriptions": {name: entry["description"] for name, entry in presets.items()},
    }
    return json.dumps(table, ensure_ascii=False, indent=1) + "\n"


def with_version(name: str, text: str, version: str) -> str:
    """The two files that say a version say this one."""
    if name == "blender_manifest.toml":
        return re.sub(r'^version = ".*"', f'version = "{version}"', text, flags=re.M)
    if name == "__init__.py":
        numbers = ", ".join(version.split("."))
        return re.sub(r'"version": \(.*\),.*', f'"version": ({numbers}),', text)
    return text


def make_folder(package: Path, version: str, folder: Path) -> Path:
    target = folder / SOURCE.name
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(SOURCE, target, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("blender_manifest.toml", "__init__.py"):
        path = target / name
        path.write_text(with_version(name, path.read_text("utf-8"), version), "utf-8")
    (target / "table.json").write_text(table_json(package), "utf-8")
    shutil.copy(LICENSE, target / "LICENSE")
    engine = target / "engine" / "craze"
    engine.mkdir(parents=True)
    for path in sorted(package.iterdir()):
        if path.suffix in {".py", ".so"} or path.name == "py.typed":
            shutil.copy(path, engine / path.name)
    return target


def make_zip(addon: Path, version: str) -> Path:
    path = addon.parent / f"craze-blender-{version}-linux-x64.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in sorted(p for p in addon.rglob("*") if p.is_file()):
            name = file.relative_to(addon.parent).as_posix()
            entry = zipfile.ZipInfo(name, FIRST_DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, file.read_bytes())
    return path


def make_index(addon: Path, archive: Path) -> None:
    """index.json beside the zip: the folder is a repository that Blender 4.2 installs from."""
    manifest = tomllib.loads((addon / "blender_manifest.toml").read_text("utf-8"))
    content = archive.read_bytes()
    entry = {
        **manifest,
        "archive_size": len(content),
        "archive_hash": "sha256:" + hashlib.sha256(content).hexdigest(),
        "archive_url": f"./{archive.name}",
    }
    index = {"version": "v1", "blocklist": [], "data": [entry]}
    (archive.parent / "index.json").write_text(json.dumps(index, indent=2) + "\n", "utf-8")


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    made = make_folder(Path(sys.argv[1]).resolve(), sys.argv[2], Path(sys.argv[3]).resolve())
    zipped = make_zip(made, sys.argv[2])
    make_index(made, zipped)
    print(zipped)
