#!/usr/bin/env bash
# Compiles the core (base, mesh, model) against libc++ with clang, to nothing: it will also run where
# there is no libstdc++, as in WebAssembly.
set -euo pipefail
cd "$(dirname "$0")/.."
find src/craze/base src/craze/mesh src/craze/model -name '*.cpp' -print0 |
  xargs -0 -n 4 -P "$(nproc)" clang++ -std=c++20 -stdlib=libc++ -fsyntax-only -Wall -Wextra -Werror \
    -I src -isystem /usr/include/eigen3
