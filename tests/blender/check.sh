#!/usr/bin/env bash
# Usage: check.sh CRAZE FOLDER. Writes meshes of every kind to FOLDER and has Blender import them. Exits
# with 77, "skipped", where Blender or the NumPy that its glTF importer wants is missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
craze=$1 folder=$2
command -v blender > /dev/null || { echo "skipped: no blender"; exit 77; }
blender -b --python-exit-code 3 --python-expr 'import numpy' > /dev/null 2>&1 || { echo "skipped: no numpy"; exit 77; }
mkdir -p "$folder"
cd "$folder"
mud=('shape:plate?n=24&jitter=0.3' --preset mud --set layer.relative_spacing=0.15 --quiet)
open=(--set post.gap=0.1 --set post.wall=0.02)
"$craze" crack "${mud[@]}" "${open[@]}" -o open.glb
"$craze" crack "${mud[@]}" "${open[@]}" -o open.ply
"$craze" crack "${mud[@]}" "${open[@]}" -o growing.glb --animate --stages 12
"$craze" crack "${mud[@]}" -o pieces.glb --fragments
"$craze" crack "${mud[@]}" -o pieces.obj --fragments
blender -b --python-exit-code 3 -P "$here/import.py" -- "$folder" | tail -n 20
python3 "$here/../gltf/truck.py" truck.glb
"$craze" crack truck.glb --preset glaze --set layer.relative_spacing=0.12 --quiet -o cracked_truck.glb
blender -b --python-exit-code 3 -P "$here/kept_scene.py" -- truck.glb cracked_truck.glb . | grep -v '^Fra:' | tail -n 20
