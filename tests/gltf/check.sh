#!/usr/bin/env bash
# Usage: check.sh CRAZE FOLDER. Writes GLB files of every kind to FOLDER and has the Khronos validator
# look at them. Exits with 77, "skipped", where npm is missing or cannot fetch the validator.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
craze=$1 folder=$2
command -v npm > /dev/null && command -v node > /dev/null || { echo "skipped: no npm"; exit 77; }
mkdir -p "$folder"
cd "$folder"
cp "$here"/package.json "$here"/package-lock.json "$here"/validate.mjs .
npm ci --no-audit --no-fund --loglevel error || { echo "skipped: the validator cannot be fetched"; exit 77; }

# Two materials, UVs with a seam, colours.
cat > quilt.obj << 'END'
v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 2 0 0.5 0 0 1
v 0 1 0 1 1 0
v 1 1 0.2 0 1 1
v 2 1 0.5 1 0 1
vt 0 0
vt 0.5 0
vt 0 1
vt 0.5 1
vt 0.6 0
vt 1 0
vt 0.6 1
vt 1 1
usemtl left
f 1/1 2/2 5/4 4/3
usemtl right
f 2/5 3/6 6/8 5/7
END
open=(--set post.gap=0.1 --set post.wall=0.02)
plate='shape:plate?n=24&jitter=0.3'
"$craze" crack shape:cup -o shut.glb --preset glaze
"$craze" crack "$plate" -o open.glb --preset mud "${open[@]}" --set post.curl=0.3
"$craze" crack "$plate" -o growing.glb --preset mud "${open[@]}" --animate --stages 12
"$craze" crack "$plate" -o pieces.glb --preset mud --fragments
"$craze" crack "$plate" -o solids.glb --preset mud --set post.thickness=0.05
"$craze" crack "$plate" -o colliders.glb --preset mud --set post.thickness=0.05 --set post.collider=unreal
"$craze" crack "$plate" -o growing_pieces.glb --preset mud "${open[@]}" --animate --fragments
"$craze" crack quilt.obj -o quilt.glb --preset mud --set mesh.edge=0.05 "${open[@]}" --animate
"$craze" crack shape:sphere -o none.glb --max-cracks 0 "${open[@]}" --animate
"$craze" crack shut.glb -o mapped.glb --as maps --map-size 128 --preset mud
"$craze" crack quilt.obj -o mapped_quilt.glb --as maps --map-size 128 --preset mud --set mesh.edge=0.05
node validate.mjs ./*.glb

# A scene with a bit of everything, in all the ways in which it comes back.
command -v python3 > /dev/null || exit 0
mkdir -p truck
cd truck
python3 "$here/truck.py" truck.glb
glaze=(truck.glb --preset glaze --set layer.relative_spacing=0.12 --quiet)
"$craze" crack "${glaze[@]}" -o shut.glb
"$craze" crack "${glaze[@]}" "${open[@]}" --set post.curl=0.5 -o open.glb
"$craze" crack "${glaze[@]}" "${open[@]}" --animate --stages 6 -o growing.glb
"$craze" crack "${glaze[@]}" "${open[@]}" --fragments -o pieces.glb
"$craze" crack "${glaze[@]}" "${open[@]}" --animate --stages 6 --fragments -o growing_pieces.glb
"$craze" crack "${glaze[@]}" --no-warnings --set post.thickness=2% --set post.collider=godot -o solids.glb
for kind in shut open growing; do python3 "$here/same_names.py" truck.glb $kind.glb; done
(cd .. && node validate.mjs --as truck/truck.glb truck/*.glb)
# On another surface its skin and its morph target are gone.
"$craze" crack "${glaze[@]}" --no-warnings --set 'mesh.output="simulation"' -o ../truck_new.glb
"$craze" crack "${glaze[@]}" --no-warnings --set 'mesh.output="simulation"' --fragments -o ../truck_new_pieces.glb
"$craze" crack "${glaze[@]}" --no-warnings --set 'mesh.output="simulation"' "${open[@]}" --animate -o ../truck_new_growing.glb
(cd .. && node validate.mjs truck_new*.glb)

# UVs that are no place for maps: a further set.
cd ..
python3 "$here/tiled.py" tiled.glb
tiled=(tiled.glb --preset mud --map-size 64 --no-warnings --quiet)
mkdir -p tiled
"$craze" crack "${tiled[@]}" --as maps -o tiled/mapped.glb
"$craze" crack "${tiled[@]}" --maps tiled/maps --map mask -o tiled/cut.glb
"$craze" crack "${tiled[@]}" --maps tiled/maps --map mask "${open[@]}" --animate --stages 6 -o tiled/growing.glb
node validate.mjs --as tiled.glb tiled/*.glb
