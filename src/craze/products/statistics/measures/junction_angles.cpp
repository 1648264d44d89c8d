#include "craze/products/statistics/measures/junction_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "craze/base/elementary.h"
#include "craze/products/statistics/graph/plane_frame.h"

namespace craze {
namespace {

using std::numbers::pi;

double wrap(double angle) {
  angle = std::fmod(angle, 2 * pi);
  return angle < 0 ? angle + 2 * pi : angle;
}

/// First and second moments of line pieces, each point weighted by arc length.
struct Moments {
  double length = 0;
  Vec2 first = Vec2::Zero();
  Mat2 second = Mat2::Zero();

  void add(const Vec2& a, const Vec2& b) {
    const double l = (b - a).norm();
    length += l;
    first += l / 2 * (a + b);
    second +=
        l / 6 *
        (2 * a * a.transpose() + 2 * b * b.transpose() + a * b.transpose() + b * a.transpose());
  }
};

/// The surface's normal over the reach of the fit: the mean along the branches, since that at the
/// node alone is one bump's on a rough surface.
Vec3 normal_around(const CrackGraph& graph, const CrackGraph::Node& node, double reach) {
  Vec3 sum = Vec3::Zero();
  for (const Dart d : node.darts) {
    const CrackGraph::Edge& edge = graph.edges()[d / 2];
    const std::size_t n = edge.points.size();
    const auto index = [&](std::size_t i) { return (d & 1) != 0 ? n - 1 - i : i; };
    double at = 0;
    for (std::size_t i = 1; i < n && at < reach; ++i) {
      const double length = (edge.points[index(i)] - edge.points[index(i - 1)]).norm();
      sum += std::min(length, reach - at) * (edge.normals[index(i - 1)] + edge.normals[index(i)]);
      at += length;
    }
  }
  const double norm = sum.norm();
  return norm > 0 ? Vec3(sum / norm) : node.normal;
}

}  // namespace

double branch_direction(const std::vector<Vec3>& points, const Vec3& normal, const Mat32& frame,
                        const BranchFit& fit) {
  const Vec3& centre = points[0];
  const auto logarithm = [&](const Vec3& p) -> Vec2 {
    const Vec3 chord = p - centre;
    const Vec3 flat = chord - normal * normal.dot(chord);
    const double length = flat.norm();
    if (length == 0) return Vec2::Zero();
    return frame.transpose() * flat * (chord.norm() / length);
  };
  double total = 0;
  for (std::size_t i = 1; i < points.size() && total < fit.to + fit.from; ++i) {
    total += (points[i] - points[i - 1]).norm();
  }
  // A short branch ends at another junction, which blurs it as this one does.
  const double from = std::min(fit.from, total / 3);
  const double to = std::min(fit.to, total - from);

  Moments m;
  double at = 0;
  for (std::size_t i = 1; i < points.size() && at < to; ++i) {
    const Vec3 step = points[i] - points[i - 1];
    const double length = step.norm();
    const double begin = std::max(from, at), end = std::min(to, at + length);
    if (length > 0 && begin < end) {
      m.add(logarithm(points[i - 1] + step * ((begin - at) / length)),
            logarithm(points[i - 1] + step * ((end - at) / length)));
    }
    at += length;
  }
  if (m.length == 0) return 0;
  const Vec2 mean = m.first / m.length;
  const Mat2 c = m.second / m.length - mean * mean.transpose();
  const double axis = elementary::atan2(2 * c(0, 1), c(0, 0) - c(1, 1)) / 2;
  const bool outward = mean.x() * elementary::cos(axis) + mean.y() * elementary::sin(axis) >= 0;
  return outward ? axis : axis + pi;
}

std::vector<double> sector_angles(const CrackGraph& graph, std::int32_t n, const BranchFit& fit) {
  const CrackGraph::Node& node = graph.nodes()[n];
  const std::size_t degree = node.darts.size();
  if (degree < 2) return std::vector<double>(degree, 2 * pi);
  const Vec3 normal = normal_around(graph, node, fit.to);
  const Mat32 frame = plane_frame(normal);
  std::vector<double> direction(degree), sectors(degree);
  for (std::size_t i = 0; i < degree; ++i) {
    const CrackGraph::Edge& edge = graph.edges()[node.darts[i] / 2];
    const bool back = node.darts[i] & 1;
    direction[i] = branch_direction(
        back ? std::vector<Vec3>(edge.points.rbegin(), edge.points.rend()) : edge.points, normal,
        frame, fit);
  }
  double sum = 0;
  for (std::size_t i = 0; i < degree; ++i) {
    sectors[i] = wrap(direction[(i + 1) % degree] - direction[i]);
    sum += sectors[i];
  }
  if (sum < 3 * pi) return sectors;
  // Farther out the branches lie in another order than at the node itself: take that order.
  std::vector<std::size_t> order(degree);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return wrap(direction[i]) < wrap(direction[j]);
  });
  for (std::size_t k = 0; k < degree; ++k) {
    sectors[order[k]] = wrap(direction[order[(k + 1) % degree]] - direction[order[k]]);
  }
  return sectors;
}

std::vector<std::vector<double>> all_sector_angles(const CrackGraph& graph, const BranchFit& fit) {
  std::vector<std::vector<double>> sectors(graph.nodes().size());
  for (std::size_t n = 0; n < sectors.size(); ++n) {
    sectors[n] = sector_angles(graph, static_cast<std::int32_t>(n), fit);
  }
  return sectors;
}

JunctionShape junction_shape(const std::vector<double>& sectors, double tolerance) {
  const double largest = *std::max_element(sectors.begin(), sectors.end());
  if (std::abs(largest - pi) <= tolerance) return JunctionShape::t;
  for (const double s : sectors) {
    if (std::abs(s - 2 * pi / 3) > tolerance) return JunctionShape::mixed;
  }
  return JunctionShape::y;
}

TParts t_parts(const CrackGraph::Node& node, const std::vector<double>& sectors) {
  const std::size_t i = std::max_element(sectors.begin(), sectors.end()) - sectors.begin();
  return {node.darts[(i + 2) % 3], {node.darts[i], node.darts[(i + 1) % 3]}};
}

}  // namespace craze
