// A mesh as another program might have written it.
#pragma once

#include <algorithm>
#include <numeric>
#include <random>

#include "craze/mesh/numbering/numbering.h"

namespace craze::test {

/// A permutation of the numbers below `count`.
inline std::vector<std::int32_t> any_order(std::size_t count, unsigned seed) {
  std::vector<std::int32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(seed);
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

/// The same surface, its vertices and faces in any order.
inline SurfaceMesh shuffled(SurfaceMesh mesh, unsigned seed) {
  renumber(mesh,
           {any_order(mesh.positions.size(), seed), any_order(mesh.triangles.size(), seed + 1)});
  return mesh;
}

}  // namespace craze::test
