#!/usr/bin/env bash
# Installs the Debian 12 packages that craze is built with; --dev adds what .ci/run checks it with.
# Run as root. Asks nothing.
set -euo pipefail

packages=(
  build-essential cmake ninja-build                  # compiler and build
  libeigen3-dev libtbb-dev libfmt-dev                # linear algebra, threads, text
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev # command line, recipes, reports
  libembree-dev libpng-dev libjpeg-dev               # pictures
  libcpp-httplib-dev pkg-config                      # craze studio
  python3-numpy                                      # the Python package
  libgtest-dev librapidcheck-dev libassimp-dev       # tests; assimp reads back what craze writes
)
development=(
  git ccache
  clang libclang-rt-14-dev libc++-14-dev libc++abi-14-dev  # sanitizers, fuzzing, the core on libc++
  clang-tidy clang-format
  mypy valgrind                                      # types of the Python package, memory of the C interface
  libbenchmark-dev
  libopenexr-dev                                     # reads back the maps that craze writes
  emscripten nodejs                                  # WebAssembly
  chromium                                           # the page's tests
  lintian mmdebstrap                                 # Debian packages
  blender xvfb xauth                                 # the add-on, in a window too
)

case "${1:-}" in
  "") ;;
  --dev)
    packages+=("${development[@]}")
    command -v npm > /dev/null || packages+=(npm)  # comes with node where that is not Debian's
    ;;
  *) echo "usage: $0 [--dev]" >&2; exit 2 ;;
esac

export DEBIAN_FRONTEND=noninteractive
apt-get update -qq
apt-get install -y -qq --no-install-recommends "${packages[@]}" < /dev/null
