#!/bin/sh
# Makes the pictures and the table of docs/gallery.md: scripts/gallery.sh CRAZE MESH_FOLDER
set -eu
craze=$(realpath "$1")
meshes=$(realpath "$2")
cd "$(dirname "$0")/../docs"
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
"$craze" figures -o "$made" --meshes "$meshes" --size 760 --quiet
# Palettes keep the repository small: fewer colours where grit hides the steps.
find "$made" -name '*.png' -size -400k -exec pngquant --force --ext .png --speed 1 64 {} +
find "$made" -name '*.png' -size +200k -exec pngquant --force --floyd=0.5 --ext .png --speed 1 32 {} +
rm -rf images/figures
mkdir -p images/figures
(cd "$made" && find . -name '*.png' -o -name '*.svg') | while IFS= read -r picture; do
  mkdir -p "images/figures/$(dirname "$picture")"
  cp "$made/$picture" "images/figures/$picture"
done
sed -i '/^<!-- below: scripts\/gallery.sh -->$/q' gallery.md
sed 's|](|](images/figures/|' "$made/figures.md" >> gallery.md
