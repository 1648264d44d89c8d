#!/usr/bin/env bash
# Builds cracked_presets for WebAssembly in build/wasm, where the page's engine is built too, and
# compares what it prints under node with what NATIVE prints: check.sh NATIVE. Skipped (77) where
# em++ or node is missing.
set -euo pipefail
native=$(realpath "$1") folder=build/wasm
for program in em++ node; do
  if ! command -v "$program" > /dev/null; then
    echo "no $program"
    exit 77
  fi
done

# Where Debian keeps the modules that emscripten's tools ask for, should node be another one.
export NODE_PATH=${NODE_PATH:+$NODE_PATH:}/usr/share/nodejs

cd "$(dirname "$0")/../.."
cmake --preset wasm
cmake --build --preset wasm --target cracked_presets --parallel "$(nproc)"
"$native" > "$folder/native.txt" &
node "$folder/tests/wasm/cracked_presets.js" > "$folder/wasm.txt"
wait $!
diff "$folder/native.txt" "$folder/wasm.txt"
