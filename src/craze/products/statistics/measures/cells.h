// The closed faces of a crack pattern.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "craze/products/statistics/graph/crack_graph.h"
#include "craze/products/statistics/graph/graph_input.h"

namespace craze {

struct Cell {
  std::vector<Dart> darts;  ///< around the cell, which lies on their left
  double area = 0;
  double perimeter = 0;
  std::int32_t nodes = 0;    ///< junctions on the boundary
  std::int32_t corners = 0;  ///< those where the cell's own angle is less than π − tolerance
  double curvature = 0;      ///< ∫K over the cell: 2π less the turning of its boundary
  bool border = false;       ///< a side is on the border of the surface
  double weight = 1;         ///< inverse chance of lying whole inside the window
};

/// The faces that are discs bounded by one loop; outer and island contours are not cells.
///
/// Areas are the mesh's own where the input names the pieces beside its edges; else those of a fan
/// around the loop's centre, exact in the plane and short by about 1 − ρ²/4 on a cell of angular
/// radius ρ. Large cells are cut by a window more often than small ones: weight is
/// |W| / |{t : cell + t in W}| by the cell's bounding box, so that weighted means over the cells
/// inside W are those of the unbounded pattern (Miles 1974).
std::vector<Cell> find_cells(const CrackGraph& graph,
                             const std::vector<std::vector<double>>& sectors, double tolerance,
                             const std::vector<double>& piece_areas,
                             const std::optional<Window>& window);

/// Weighted mean area of the cells that are not at the border, of all cells if none is; 0 without
/// cells.
double mean_cell_area(const std::vector<Cell>& cells);

}  // namespace craze
