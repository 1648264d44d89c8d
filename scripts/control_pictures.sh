#!/bin/sh
# Makes the pictures of docs/controls.md with the commands that stand there:
# scripts/control_pictures.sh CRAZE [OPTION]... ; options are added to each command.
set -eu
craze=$(realpath "$1")
shift
cd "$(dirname "$0")/../docs"
mkdir -p images/controls
sed -n 's/.*| `craze crack \(.*\)` |$/\1/p' controls.md | while IFS= read -r arguments; do
  eval "\"$craze\" crack $arguments --quiet --width 400 --height 300 $*"
done
# Palettes keep the repository small; without pngquant the pictures are only larger.
if command -v pngquant > /dev/null; then
  pngquant --force --ext .png --speed 1 96 images/controls/*.png
fi
