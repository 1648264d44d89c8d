#include <Eigen/Eigenvalues>
#include <cmath>
#include <set>
#include <utility>

#include "craze/error.h"
#include "craze/mesh/repair/weld.h"
#include "craze/products/statistics/graph/graph_input.h"
#include "craze/products/statistics/graph/pixel_diagonals.h"
#include "craze/products/statistics/graph/plane_frame.h"
#include "craze/products/statistics/graph/point_index.h"

namespace craze {
namespace {

/// The unit normal of the plane that fits the points best, and whether it fits.
std::optional<Vec3> common_normal(const std::vector<Vec3>& points) {
  if (points.empty()) return Vec3::UnitZ();
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& p : points) covariance += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(covariance);
  Vec3 normal = solver.eigenvectors().col(0);
  double thickness = 0, extent = 0;
  for (const Vec3& p : points) {
    thickness = std::max(thickness, std::abs(normal.dot(p - mean)));
    extent = std::max(extent, (p - mean).norm());
  }
  if (thickness > 1e-3 * extent) return std::nullopt;
  for (int axis = 2; axis >= 0; --axis) {
    if (std::abs(normal[axis]) < 1e-9) continue;
    if (normal[axis] < 0) normal = -normal;
    break;
  }
  return normal;
}

/// Makes one of points closer than `meeting_distance` times the diagonal of their box. Fills
/// `joined` in order of first appearance and returns the place of each point in it.
std::vector<std::int32_t> join_points(const std::vector<Vec3>& points, std::vector<Vec3>& joined) {
  if (points.empty()) return {};
  Vec3 low = points[0], high = low;
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<std::int32_t> place = weld(points, meeting_distance * (high - low).norm());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto first = static_cast<std::size_t>(place[i]);
    place[i] = first == i ? static_cast<std::int32_t>(joined.size()) : place[first];
    if (first == i) joined.push_back(points[i]);
  }
  return place;
}

}  // namespace

CrackGraphInput graph_from_lines(const LineSet& lines) {
  CrackGraphInput graph;
  const std::vector<std::int32_t> welded = join_points(lines.points, graph.points);

  const Attribute* normals = find_attribute(lines.point_attributes, "normal");
  if (normals && normals->components == 3) {
    graph.normals.assign(graph.points.size(), Vec3::Zero());
    for (std::size_t i = 0; i < lines.points.size(); ++i) {
      graph.normals[welded[i]] += Eigen::Map<const Vec3>(normals->values.data() + 3 * i);
    }
    for (Vec3& n : graph.normals) n = n.norm() > 0 ? Vec3(n.normalized()) : Vec3::UnitZ();
  } else {
    const auto normal = common_normal(graph.points);
    if (!normal) {
      throw Error(ErrorKind::request, "lines are not in a plane", "normal",
                  "give a normal per point (PLY: nx ny nz), or the cracked mesh itself");
    }
    graph.normals.assign(graph.points.size(), *normal);
  }

  std::set<std::pair<std::int32_t, std::int32_t>> known;
  const Attribute* time = find_attribute(lines.edge_attributes, "time");
  const Attribute* event = find_attribute(lines.edge_attributes, "event");
  const Attribute* border = find_attribute(lines.edge_attributes, "border");
  for (std::size_t e = 0; e < lines.edges.size(); ++e) {
    GraphInputEdge edge;
    edge.a = welded[lines.edges[e][0]];
    edge.b = welded[lines.edges[e][1]];
    if (time) edge.time = time->values[e];
    if (event) edge.event = static_cast<std::int32_t>(event->values[e]);
    edge.border = border && border->values[e] != 0;
    if (edge.a == edge.b || !known.insert(std::minmax({edge.a, edge.b})).second) continue;
    graph.edges.push_back(edge);
  }
  drop_pixel_diagonals(graph);
  return graph;
}

std::optional<Window> find_window(const CrackGraphInput& input) {
  if (input.points.empty()) return std::nullopt;
  Window window;
  const Vec3 normal = input.normals[0];
  window.frame = plane_frame(normal);
  window.low = window.high = window.frame.transpose() * input.points[0];
  double thickness = 0;
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    if ((input.normals[i] - normal).norm() > 1e-6) return std::nullopt;
    const Vec2 q = window.frame.transpose() * input.points[i];
    window.low = window.low.cwiseMin(q);
    window.high = window.high.cwiseMax(q);
    thickness = std::max(thickness, std::abs(normal.dot(input.points[i] - input.points[0])));
  }
  const double extent = (window.high - window.low).norm();
  // As thin as rounding: the points lie on a line, which has no inside.
  const Vec2 sides = window.high - window.low;
  if (!(sides.minCoeff() > 1e-9 * extent) || thickness > 2e-3 * extent) return std::nullopt;
  // A drawn border must run along the sides of the box, all of them.
  double drawn = 0;
  for (const GraphInputEdge& e : input.edges) {
    if (!e.border) continue;
    const Vec2 a = window.frame.transpose() * input.points[e.a];
    const Vec2 b = window.frame.transpose() * input.points[e.b];
    bool on_side = false;
    for (int axis = 0; axis < 2; ++axis) {
      for (const double side : {window.low[axis], window.high[axis]}) {
        on_side |= std::max(std::abs(a[axis] - side), std::abs(b[axis] - side)) < 1e-9 * extent;
      }
    }
    if (!on_side) return std::nullopt;
    drawn += (b - a).norm();
  }
  window.drawn = drawn > 0;
  if (window.drawn && std::abs(drawn - 2 * (window.high - window.low).sum()) > 1e-6 * extent) {
    return std::nullopt;
  }
  return window;
}

}  // namespace craze
