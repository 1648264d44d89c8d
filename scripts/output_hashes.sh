#!/usr/bin/env bash
# Hashes of what a command makes of every preset on tests/same_bytes/shapes.txt, one line each:
#   scripts/output_hashes.sh COMMAND [MESH]...
# COMMAND is a built craze and its first arguments, as one word or several: "node craze.js". MESHes
# come after the shapes. Two builds agree where the lines do. CRAZE_PICTURES=0 leaves pictures out.
set -euo pipefail
[ $# -gt 0 ] || { sed -n '2,5s/^# //p' "$0" >&2; exit 2; }
read -ra craze <<< "$1"
shift
here=$(cd "$(dirname "$0")/.." && pwd)
mapfile -t inputs < "$here/tests/same_bytes/shapes.txt"
inputs+=("$@")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

for recipe in "$here"/recipes/*.toml; do
  for input in "${inputs[@]}"; do
    outputs=(-o "$folder/mesh.ply" --lines "$folder/lines.json" --max-cracks 200)
    [ "${CRAZE_PICTURES:-1}" = 0 ] ||
      outputs+=(--picture "$folder/picture.png" --width 160 --height 120 --samples 4)
    "${craze[@]}" crack "$input" --recipe "$recipe" "${outputs[@]}" --quiet > "$folder/out"
    for file in "$folder"/*.*; do
      printf '%s  %s %s %s\n' "$(sha256sum < "$file" | cut -c 1-32)" "$(basename "$recipe" .toml)" \
        "${input##*/}" "$(basename "$file")"
    done
    rm "$folder"/*
  done
done
