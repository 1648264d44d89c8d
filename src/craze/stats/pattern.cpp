#include "craze/stats/pattern.h"

#include <cmath>

#include "craze/stats/cells.h"

namespace craze {

namespace {

double unit_without_cells(const Pattern& pattern) {
  double length = 0;
  for (const auto& e : pattern.raw.edges()) length += e.border ? 0 : e.length;
  double area = pattern.input.surface_area;
  if (area == 0 && pattern.window) area = pattern.window->area();
  return length > 0 ? 2 * area / length : 0;
}

std::vector<BorderSegment> sides(const Window& window, const Vec3& point, const Vec3& normal) {
  const Vec2 corners[4] = {window.low,
                           {window.high.x(), window.low.y()},
                           window.high,
                           {window.low.x(), window.high.y()}};
  const Vec3 height = normal * normal.dot(point);
  std::vector<BorderSegment> segments;
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
  unit = std::sqrt(mean_cell_area(find_cells(raw, sectors, 0, input.piece_areas, window)));
  if (unit == 0) unit = unit_without_cells(*this);
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
