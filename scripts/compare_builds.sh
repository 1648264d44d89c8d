#!/usr/bin/env bash
# Builds the command by other compilers and for other instruction sets than build/release, and
# fails where what they make differs in a byte: scripts/compare_builds.sh [MESH]...
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build/bytes
scripts/output_hashes.sh build/release/craze "$@" > build/bytes/release.txt
code=0
for preset in narrow clang; do
  cmake --preset "$preset" > /dev/null
  cmake --build "build/$preset" --target craze_app -- --quiet
  scripts/output_hashes.sh "build/$preset/craze" "$@" > "build/bytes/$preset.txt"
  if diff "build/bytes/release.txt" "build/bytes/$preset.txt"; then
    echo "$preset: $(wc -l < "build/bytes/$preset.txt") files, the same bytes"
  else
    echo "$preset: other bytes than release" >&2
    code=1
  fi
done
exit $code
