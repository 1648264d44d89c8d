#!/usr/bin/env bash
# Runs what the README's first command runs once the build is there, and checks its two files.
set -euo pipefail
cd "$(dirname "$0")/.."
first=$(grep -m 1 '^scripts/install-deps.sh &&' README.md)
example=${first##*&& }
rm -f cracked.glb cracked.png
echo "$example"
eval "$example"
for file in cracked.glb cracked.png; do
  [ -s "$file" ] || { echo "$file did not come out" >&2; exit 1; }
done
