#!/usr/bin/env bash
# What takes long: sanitizers, fuzzing, clang-tidy, the core on libc++. Run as root from anywhere; the
# last line counts the tests of all builds. .ci/run holds the rest.
set -euo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C.UTF-8 CTEST_OUTPUT_ON_FAILURE=1

current=
step() {
  current=$1
  printf '\n== %s (%d min %02d s)\n' "$current" $((SECONDS / 60)) $((SECONDS % 60))
}

# Adds up what each ctest run wrote to build/PRESET/tests.xml.
count() {
  sed -n "s/^\t$1=\"\([0-9]*\)\"/\1/p" build/*/tests.xml 2> /dev/null | awk '{n += $1} END {print n + 0}' || true
}

finish() {
  local code=$? tests failures unrun
  tests=$(count tests) failures=$(count failures) unrun=$(($(count skipped) + $(count disabled)))
  printf '\n%d min %02d s\n' $((SECONDS / 60)) $((SECONDS % 60))
  [ "$code" -eq 0 ] || echo "failed at: $current"
  # A step that is no test counts as one where it failed.
  [ "$code" -eq 0 ] || [ "$failures" -gt 0 ] || failures=1 tests=$((tests + 1))
  echo "$((tests - failures - unrun)) passed, $failures failed"
}
trap finish EXIT
rm -f build/*/tests.xml

step "packages"
scripts/install-deps.sh --dev
if [ -z "${CMAKE_CXX_COMPILER_LAUNCHER:-}" ]; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi

step "the core on libc++"
scripts/check_libcxx.sh

step "address and undefined behaviour: all tests"
cmake --workflow --preset asan

step "fuzzing"
CRAZE_FUZZ_BUILD=build/asan fuzz/run.sh 10

step "threads: the tests that use several"
cmake --preset tsan
cmake --build --preset tsan --target test_mesh test_model test_render
ctest --preset tsan -L 'mesh|model|render'

step "clang-tidy"
run-clang-tidy -quiet -j "$(nproc)" -p build/release '/(src/craze|apps)/'
