// What is told of cracks while they grow.
#pragma once

#include <cstdint>
#include <functional>

#include "craze/tensor.h"

namespace craze {

/// A straight piece of crack that has just opened, on the mesh that the simulation runs on.
struct OpenedPiece {
  std::int64_t number;  ///< from 0; with 0 the pattern begins anew (evolution.cycles, layer.rounds)
  Vec3 from, to;        ///< its ends as they lie now; a vertex may yet slide (crack.near_vertex)
};

/// Called from the thread that runs, for each piece in its order. May be empty: nobody listens.
using OnOpened = std::function<void(const OpenedPiece&)>;

}  // namespace craze
