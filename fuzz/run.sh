#!/bin/sh
# Runs each fuzz target for SECONDS (default 60), starting from fuzz/corpus; fails on the first find.
# New inputs stay in the build folder, and so does the input that broke a target.
# Build first: cmake --workflow --preset fuzz. CRAZE_FUZZ_BUILD names another build folder.
set -eu
seconds=${1:-60}
here=$(cd "$(dirname "$0")" && pwd)
build=${CRAZE_FUZZ_BUILD:-$here/../build/fuzz}
for format in obj ply stl off gltf mesh lines image recipe; do
  echo "fuzz_$format: $seconds s"
  mkdir -p "$build/found/$format"
  "$build/fuzz/fuzz_$format" "$build/found/$format" "$here/corpus/$format" \
    -max_total_time="$seconds" -timeout=5 -rss_limit_mb=1024 -malloc_limit_mb=512 \
    -max_len=65536 -dict="$here/$format.dict" \
    -artifact_prefix="$build/found/$format-" -verbosity=0 -print_final_stats=0
done
