// Edges of a pixel skeleton that say nothing new.
#pragma once

#include "craze/products/statistics/graph/graph_input.h"

namespace craze {

/// Skeletons whose pixels are joined with all eight neighbours have, at corners and junctions,
/// diagonals beside two straight steps that lead to the same pixel; each would be counted as a
/// cell. Leaves out an edge whose ends are also joined over one further point by two edges at a
/// right angle, both as short as the shortest edge of the graph, within 10⁻⁶ of that. Borders and
/// edges with a known time stay.
void drop_pixel_diagonals(CrackGraphInput& graph);

}  // namespace craze
