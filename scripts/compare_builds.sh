#!/usr/bin/env bash
# Builds the command by other compilers and for other instruction sets than build/release, and
# fails where what they make differs in a byte: scripts/compare_builds.sh PRESET... [-- MESH...]
# The presets "narrow" and "clang" are made for it.
set -euo pipefail
cd "$(dirname "$0")/.."
presets=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do presets+=("$1"); shift; done
[ $# -eq 0 ] || shift
[ ${#presets[@]} -gt 0 ] || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
mkdir -p build/bytes
scripts/output_hashes.sh build/release/craze "$@" > build/bytes/release.txt
code=0
for preset in "${presets[@]}"; do
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
