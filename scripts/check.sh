#!/usr/bin/env bash
# Everything that must hold before a change goes in: scripts/check.sh [STEP]...
# Without arguments all steps, as on a bare Debian 12; run as root then ("packages" installs).
# The last line counts the tests of all builds, and each step that is no test and failed.
set -uo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C.UTF-8 CTEST_OUTPUT_ON_FAILURE=1
export CCACHE_BASEDIR=$PWD  # what two build folders compile alike is compiled once
fuzz_seconds=${CRAZE_FUZZ_SECONDS:-10}  # per target

all=(packages format release example long debs core narrow clang wasm libcxx asan fuzz tsan tidy)

step_packages() { scripts/install-deps.sh --dev; }
step_format() { git ls-files '*.h' '*.cpp' | xargs clang-format --dry-run --Werror; }
# What the README says runs all tests.
step_release() {
  grep -qx 'cmake --workflow --preset release' README.md
  cmake --workflow --preset release
}
# What the README says first.
step_example() { scripts/readme_example.sh; }
# All pairs of edge values and more random recipes; after "release".
step_long() { ctest --preset long -LE wasm; }
# The Debian packages, in a bare root; after "release".
step_debs() { scripts/check_debs.sh; }
# Without Embree, libpng, libjpeg and TBB: not a header of them is read.
step_core() {
  cmake --workflow --preset core
  ! ninja -C build/core -t deps | grep -E '/(embree3|tbb|oneapi)/|/(png|jpeglib)\.h$'
}
# The same bytes without AVX2, and by the other compiler; after "release".
step_narrow() { scripts/compare_builds.sh narrow; }
step_clang() { scripts/compare_builds.sh clang; }
# The same bytes from WebAssembly; after "release".
step_wasm() { ctest --test-dir build/release -L wasm --output-on-failure; }
step_libcxx() { scripts/check_libcxx.sh; }
# All tests, with AddressSanitizer and UndefinedBehaviorSanitizer.
step_asan() { cmake --workflow --preset asan; }
step_fuzz() { cmake --workflow --preset fuzz && fuzz/run.sh "$fuzz_seconds"; }
# All tests, with ThreadSanitizer.
step_tsan() { cmake --workflow --preset tsan; }
step_tidy() { cmake --workflow --preset tidy; }

steps=("$@")
[ $# -gt 0 ] || steps=("${all[@]}")
for step in "${steps[@]}"; do
  if ! declare -F "step_$step" > /dev/null; then
    echo "no step \"$step\"; there are: ${all[*]}" >&2
    exit 2
  fi
done

# Adds up what each ctest run wrote to build/PRESET/tests.xml.
count() {
  sed -n "s/^\t$1=\"\([0-9]*\)\"/\1/p" build/*/tests.xml 2> /dev/null | awk '{n += $1} END {print n + 0}'
}

rm -f build/*/tests.xml
table="" bad=0
for step in "${steps[@]}"; do
  printf '\n== %s\n' "$step"
  begin=$SECONDS before=$(count failures)
  (set -e; "step_$step")
  code=$?
  # ccache is there from the first step on.
  if [ -z "${CMAKE_CXX_COMPILER_LAUNCHER:-}" ] && command -v ccache > /dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  took=$((SECONDS - begin)) outcome=ok
  if [ "$code" -ne 0 ]; then
    outcome=FAILED
    [ "$(count failures)" -gt "$before" ] || bad=$((bad + 1))
  fi
  table+=$(printf '%-9s %3d min %02d s  %s' "$step" $((took / 60)) $((took % 60)) "$outcome")$'\n'
done

failures=$(($(count failures) + bad))
passed=$(($(count tests) - $(count failures) - $(count skipped) - $(count disabled)))
printf '\n%s\n%d min %02d s\n' "$table" $((SECONDS / 60)) $((SECONDS % 60))
echo "$passed passed, $failures failed"
[ "$failures" -eq 0 ]
