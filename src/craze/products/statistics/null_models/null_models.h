// Patterns that know nothing of mechanics: what a measured number must be compared with.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "craze/model/crack_network.h"
#include "craze/products/statistics/graph/graph_input.h"

namespace craze {

enum class NullModel {
  poisson_voronoi,       ///< cells of points placed at random
  orthogonal_splitting,  ///< the largest cell is cut across its longer side, near its middle
  stit,  ///< each cell is cut by a random line at a rate proportional to its perimeter
  square,
  hexagonal,
  brick,  ///< running bond, bricks twice as long as high
};

inline constexpr NullModel all_null_models[] = {NullModel::poisson_voronoi,
                                                NullModel::orthogonal_splitting,
                                                NullModel::stit,
                                                NullModel::square,
                                                NullModel::hexagonal,
                                                NullModel::brick};

/// "voronoi", "orthogonal", "stit", "square", "hexagonal", "brick".
std::string_view to_string(NullModel model);

/// Fraction of the longer side at which orthogonal splitting cuts, uniform in this range.
inline constexpr double orthogonal_cut[2] = {0.3, 0.7};

/// The model in the window [0, √cells]² of the xy plane: about `cells` cells of area about 1, those
/// at the border cut off by it. Splitting models make exactly that many, and number their cuts as
/// events. Lattices take no seed. cells ≥ 1.
CrackNetwork null_network(NullModel model, std::int32_t cells, std::uint64_t seed);

/// A network in the window [0, side]², with the window's sides as border edges.
CrackGraphInput graph_in_square(const CrackNetwork& network, double side);

/// Both at once.
CrackGraphInput null_graph(NullModel model, std::int32_t cells, std::uint64_t seed);

/// From "NAME", "NAME?cells=N", "NAME?cells=N&seed=S"; 2000 cells and seed 1 where not given.
/// Throws Error(usage) for anything else, or more than a million cells.
CrackGraphInput null_graph(const std::string& text);

}  // namespace craze
