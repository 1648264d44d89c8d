"""make_wheel.py PACKAGE VERSION FOLDER: PACKAGE, with its libcraze.so, as a wheel in FOLDER.

Needs Python alone. The same package gives the same bytes. Prints the wheel's path.
"""

from __future__ import annotations

import base64
import hashlib
import platform
import sys
import zipfile
from pathlib import Path

README = Path(__file__).resolve().parents[2] / "docs" / "python.md"
LICENSE = Path(__file__).resolve().parents[2] / "LICENSE"
FIRST_DATE = (1980, 1, 1, 0, 0, 0)  # of the zip format


def metadata(version: str) -> str:
    head = {
        "Metadata-Version": "2.1",
        "Name": "craze",
        "Version": version,
        "Summary": "Surface crack patterns on triangle meshes: mud, glaze, glass, paint",
        "License": "MIT",
        "Requires-Python": ">=3.8",
        "Requires-Dist": "numpy>=1.21",
        "Description-Content-Type": "text/markdown",
    }
    lines = [f"{key}: {value}" for key, value in head.items()]
    return "\n".join(lines) + "\n\n" + README.read_text(encoding="utf-8")


def make_wheel(package: Path, version: str, folder: Path) -> Path:
    tag = f"py3-none-linux_{platform.machine()}"
    info = f"craze-{version}.dist-info"
    files = {
        f"craze/{path.name}": path.read_bytes()
        for path in sorted(package.iterdir())
        if path.suffix in {".py", ".so"} or path.name == "py.typed"
    }
    files[f"{info}/LICENSE"] = LICENSE.read_bytes()
    files[f"{info}/METADATA"] = metadata(version).encode()
    files[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: craze\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    )
    record = ""
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(content)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()

    wheel = folder / f"craze-{version}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, FIRST_DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content)
    return wheel


if __name__ == "__main__":
    print(make_wheel(Path(sys.argv[1]).resolve(), sys.argv[2], Path(sys.argv[3]).resolve()))
