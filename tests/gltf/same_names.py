"""same_names.py BEFORE.glb AFTER.glb: everything with a name has it still, in the same order, but for
what cracks add."""

import json
import struct
import sys

KINDS = ("scenes", "nodes", "meshes", "materials", "textures", "images", "samplers", "animations",
         "skins", "cameras")


def names(path, kind):
    with open(path, "rb") as file:
        data = file.read()
    root = json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])
    listed = [item.get("name") for item in root.get(kind, [])]
    return listed


before, after = sys.argv[1:]
for kind in KINDS:
    wanted, found = names(before, kind), names(after, kind)
    added = found[len(wanted):]
    if found[: len(wanted)] != wanted:
        sys.exit(f"{after}: {kind} are {found}, not {wanted}")
    if any(not str(name).startswith(("crack_", "fragment_", "growth")) for name in added) and kind != "meshes":
        sys.exit(f"{after}: new {kind}: {added}")
