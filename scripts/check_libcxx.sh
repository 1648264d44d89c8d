#!/usr/bin/env bash
# Compiles what is built for WebAssembly too (base, mesh, model, recipe, engine, products) against
# libc++ with clang, to nothing: it will also run where
# there is no libstdc++.
set -euo pipefail
cd "$(dirname "$0")/.."
find src/craze/{base,mesh,model,recipe,engine,products} -name '*.cpp' -print0 |
  xargs -0 -n 4 -P "$(nproc)" clang++ -std=c++20 -stdlib=libc++ -fsyntax-only -Wall -Wextra -Werror \
    -DCRAZE_VERSION='""' -I include -I src -isystem /usr/include/eigen3
