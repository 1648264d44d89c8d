#include "craze/products/statistics/measures/pattern.h"

#include <cmath>

#include "craze/products/statistics/measures/cells.h"

namespace craze {

namespace {

double surface_area(const Pattern& pattern) {
  if (pattern.input.surface_area > 0) return pattern.input.surface_area;
  return pattern.window ? pattern.window->area() : 0;
}

double unit_from_length(const Pattern& pattern) {
  double length = 0;
  for (const auto& e : pattern.raw.edges()) length += e.border ? 0 : e.length;
  return length > 0 ? 2 * surface_area(pattern) / length : 0;
}

std::vector<BorderSegment> sides(const Window& window, const Vec3& point, const Vec3& normal) {
  const Vec2 corners[4] = {window.low,
                           {window.high.x(), window.low.y()},
                           window.high,
                           {window.low.x(), window.high.y()}};
  const Vec3 height = normal * normal.dot(point);
  std::vector<BorderSegment> segments;
  segments.reserve(4);
  for (int k = 0; k < 4; ++k) {
    segments.push_back(
        {window.frame * corners[k] + height, window.frame * corners[(k + 1) % 4] + height});
  }
  return segments;
}

}  // namespace

Pattern::Pattern(const CrackGraphInput& graph, const StatisticsOptions& o)
    : input(graph), options(o), window(find_window(graph)), raw(graph) {
  for (const GraphInputEdge& e : input.edges) {
    if (e.border) border.push_back({input.points[e.a], input.points[e.b]});
  }
  if (border.empty() && window) border = sides(*window, input.points[0], input.normals[0]);
  const auto sectors = all_sector_angles(raw, {0, 0});
  const std::vector<Cell> cells = find_cells(raw, sectors, 0, input.piece_areas, window);
  double covered = 0;
  for (const Cell& c : cells) covered += c.border ? 0 : c.area;
  unit = std::sqrt(mean_cell_area(cells));
  // A few small cells between open cracks are no measure of the pattern.
  if (covered < 0.1 * surface_area(*this) || unit == 0) unit = unit_from_length(*this);
}

CrackGraph Pattern::simplified(double length) const {
  CrackGraph graph = raw;
  graph.prune_spurs(length * unit);
  graph.contract_edges(length * unit);
  return graph;
}

std::vector<char> Pattern::near_border_nodes(const CrackGraph& graph) const {
  std::vector<Vec3> positions;
  for (const auto& n : graph.nodes()) positions.push_back(n.position);
  std::vector<char> near(positions.size(), 0);
  const double margin = options.border_margin * unit;
  if (margin > 0) near = near_border(positions, border, margin);
  for (std::size_t n = 0; n < near.size(); ++n) near[n] |= graph.nodes()[n].border;
  return near;
}

}  // namespace craze
