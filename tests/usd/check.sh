#!/usr/bin/env bash
# Usage: check.sh CRAZE FOLDER. Writes USDA files of every kind to FOLDER and has TinyUSDZ read them. Exits with
# 77, "skipped", where npm or Python is missing or npm cannot fetch the reader.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
craze=$1 folder=$2
for tool in npm node python3; do command -v $tool > /dev/null || { echo "skipped: no $tool"; exit 77; }; done
mkdir -p "$folder"
cd "$folder"
cp "$here"/package.json "$here"/package-lock.json "$here"/read.mjs .
npm ci --no-audit --no-fund --loglevel error || { echo "skipped: the reader cannot be fetched"; exit 77; }
python3 -B "$here/../gltf/tiled.py" tiled.glb
# The same with textures that do not repeat.
python3 - << 'END'
import struct
glb = open("tiled.glb", "rb").read()
size = struct.unpack("<I", glb[12:16])[0]
text = glb[20 : 20 + size].replace(b'"magFilter": 9729,', b'"wrapS": 33071, "wrapT": 33648,')
text += b" " * (-len(text) % 4)
rest = glb[20 + size :]
with open("clamped.glb", "wb") as file:
    file.write(struct.pack("<4sII", b"glTF", 2, 20 + len(text) + len(rest)))
    file.write(struct.pack("<I4s", len(text), b"JSON") + text + rest)
END
crack() { "$craze" crack "$@" --preset mud --quiet --no-warnings --report "$name.json" -o "$name.usda"; }
open=(--set post.gap=0.1 --set post.wall=0.02)
name=scene crack tiled.glb
name=clamped crack clamped.glb
name=open crack 'shape:plate?n=16&jitter=0.3' "${open[@]}"
name=growing crack 'shape:plate?n=16&jitter=0.3' "${open[@]}" --animate --stages 6
name=pieces crack 'shape:plate?n=16&jitter=0.3' "${open[@]}" --fragments
node read.mjs scene clamped open growing pieces
