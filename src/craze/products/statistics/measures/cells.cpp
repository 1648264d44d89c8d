#include "craze/products/statistics/measures/cells.h"

#include <cmath>
#include <map>
#include <numbers>

#include "craze/base/elementary.h"

namespace craze {
namespace {

/// Signed angle from a to b around the normal.
double turn(const Vec3& a, const Vec3& b, const Vec3& normal) {
  const Vec3 u = a - normal * normal.dot(a), v = b - normal * normal.dot(b);
  return elementary::atan2(normal.dot(u.cross(v)), u.dot(v));
}

/// Turning of a polyline at its inner points, left positive.
double turning(const CrackGraph::Edge& edge) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < edge.points.size(); ++i) {
    const Vec3 a = edge.points[i] - edge.points[i - 1], b = edge.points[i + 1] - edge.points[i];
    if (a.norm() > 0 && b.norm() > 0) sum += turn(a, b, edge.normals[i]);
  }
  return sum;
}

/// The boundary of a face as a closed polygon.
struct Loop {
  std::vector<Vec3> points;
  Vec3 normal = Vec3::Zero();  ///< mean over its length; shorter than 1 where it varies
};

Loop loop_of(const CrackGraph& graph, const std::vector<Dart>& darts) {
  Loop loop;
  double length = 0;
  for (const Dart d : darts) {
    const CrackGraph::Edge& edge = graph.edges()[d / 2];
    const std::size_t n = edge.points.size();
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const std::size_t i = d & 1 ? n - 1 - k : k, j = d & 1 ? i - 1 : i + 1;
      const double l = (edge.points[j] - edge.points[i]).norm();
      loop.points.push_back(edge.points[i]);
      loop.normal += l / 2 * (edge.normals[i] + edge.normals[j]);
      length += l;
    }
  }
  if (length > 0) loop.normal /= length;
  return loop;
}

/// The area of a loop that runs counter-clockwise around its inside; 0 for any other.
double fan_area(const Loop& loop) {
  if (loop.normal.norm() < 0.2) return 0;  // runs around the object: no side is a disc
  const std::size_t n = loop.points.size();
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : loop.points) centre += p;
  centre /= static_cast<double>(n);
  double area = 0, length = 0;
  for (std::size_t i = 0; i < n; ++i) {
    length += (loop.points[(i + 1) % n] - loop.points[i]).norm();
    const Vec3 a = (loop.points[i] - centre).cross(loop.points[(i + 1) % n] - centre) / 2;
    area += std::copysign(a.norm(), a.dot(loop.normal));
  }
  // Around a crack that touches nothing the area is zero up to rounding.
  return area > 1e-9 * length * length ? area : 0;
}

/// The piece that lies on the left of most of the loop's length; −1 if not known.
std::int32_t piece_of(const CrackGraph& graph, const std::vector<Dart>& darts) {
  std::map<std::int32_t, double> length;
  for (const Dart d : darts) {
    const CrackGraph::Edge& edge = graph.edges()[d / 2];
    for (std::size_t i = 0; i < edge.segments.size(); ++i) {
      const auto& s = edge.segments[i];
      length[d & 1 ? s.right_piece : s.left_piece] += (edge.points[i + 1] - edge.points[i]).norm();
    }
  }
  std::int32_t piece = -1;
  double longest = 0;
  for (const auto& [p, l] : length) {
    if (l > longest) {
      piece = p;
      longest = l;
    }
  }
  return piece;
}

double window_weight(const Loop& loop, const Window& window) {
  Vec2 low = window.high, high = window.low;
  for (const Vec3& p : loop.points) {
    const Vec2 q = window.frame.transpose() * p;
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  const Vec2 room = (window.high - window.low) - (high - low);
  return room.minCoeff() > 0 ? window.area() / room.prod() : 1;
}

}  // namespace

std::vector<Cell> find_cells(const CrackGraph& graph,
                             const std::vector<std::vector<double>>& sectors, double tolerance,
                             const std::vector<double>& piece_areas,
                             const std::optional<Window>& window) {
  constexpr double pi = std::numbers::pi;
  std::vector<double> sector_left_of(2 * graph.edges().size(), 0);  // at the dart's origin
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    const std::vector<Dart>& darts = graph.nodes()[n].darts;
    for (std::size_t i = 0; i < darts.size(); ++i) sector_left_of[darts[i]] = sectors[n][i];
  }
  std::vector<Cell> cells;
  for (auto& darts : graph.trace_faces()) {
    const Loop loop = loop_of(graph, darts);
    Cell cell;
    cell.area = fan_area(loop);
    if (!(cell.area > 0)) continue;
    const std::int32_t piece = piece_areas.empty() ? -1 : piece_of(graph, darts);
    if (piece >= 0) cell.area = piece_areas[piece];
    cell.curvature = 2 * pi;
    for (const Dart d : darts) {
      const CrackGraph::Edge& edge = graph.edges()[d / 2];
      cell.perimeter += edge.length;
      cell.border |= edge.border;
      cell.curvature -= pi - sector_left_of[d] + (d & 1 ? -1 : 1) * turning(edge);
      if (graph.degree(graph.origin(d)) < 3) continue;
      ++cell.nodes;
      if (sector_left_of[d] < pi - tolerance) ++cell.corners;
    }
    if (loop.normal.norm() > 1 - 1e-9) cell.curvature = 0;
    if (window && !cell.border) cell.weight = window_weight(loop, *window);
    cell.darts = std::move(darts);
    cells.push_back(std::move(cell));
  }
  return cells;
}

double mean_cell_area(const std::vector<Cell>& cells) {
  double area = 0, weight = 0, all = 0;
  for (const Cell& c : cells) {
    all += c.area;
    if (c.border) continue;
    area += c.weight * c.area;
    weight += c.weight;
  }
  if (weight > 0) return area / weight;
  return cells.empty() ? 0 : all / static_cast<double>(cells.size());
}

}  // namespace craze
