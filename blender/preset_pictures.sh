#!/usr/bin/env bash
# Usage: preset_pictures.sh CRAZE. Makes the panel's pictures anew, one of each preset: a plate from
# above, filling the picture, in 32 colours of its own: the studio's page loads them too. About five
# minutes, nearly all of it the cycles of mud-mature. Needs Pillow (python3-pil).
set -euo pipefail
folder=$(cd "$(dirname "$0")" && pwd)/craze_blender/pictures
mkdir -p "$folder"
for preset in $("$1" presets | cut -d ' ' -f 1); do
  "$1" crack 'shape:plate?n=40&jitter=0.3' --preset "$preset" --seed 1 --quiet --no-warnings \
    --picture "$folder/$preset.png" --width 96 --height 96 --elevation 90 --zoom 1.5 --line-width 0.012
done
python3 - "$folder" <<'EOF'
import pathlib, sys
from PIL import Image
for path in pathlib.Path(sys.argv[1]).glob("*.png"):
    picture = Image.open(path).convert("RGB")
    picture.quantize(32, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(path, optimize=True)
EOF
