#!/usr/bin/env bash
# Usage: run.sh ADDON TEST.py. Runs the tests of a file inside Blender, with the add-on in the folder
# ADDON/craze_blender. With the first line "# needs a window", under Xvfb. Exits with 77, "skipped",
# where Blender, its NumPy or Xvfb is missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
command -v blender > /dev/null || { echo "skipped: no blender"; exit 77; }
blender -b --python-exit-code 3 --python-expr 'import numpy' > /dev/null 2>&1 || { echo "skipped: no numpy"; exit 77; }
run=(blender -b)
if head -1 "$2" | grep -q "needs a window"; then
  command -v xvfb-run > /dev/null || { echo "skipped: no xvfb-run"; exit 77; }
  run=(xvfb-run -a -s "-screen 0 800x600x24" blender --window-geometry 0 0 800 600
    --enable-event-simulate)
fi
export PYTHONPATH="$1:$here${PYTHONPATH:+:$PYTHONPATH}"
exec "${run[@]}" --factory-startup --python-use-system-env --python-exit-code 3 --python "$here/run.py" -- "$2"
