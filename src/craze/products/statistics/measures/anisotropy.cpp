#include "craze/products/statistics/measures/anisotropy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "craze/base/elementary.h"
#include "craze/products/statistics/graph/plane_frame.h"

namespace craze {
namespace {

using std::numbers::pi;

struct Line {
  double length = 0, angle = 0;
  std::complex<double> doubled = 0;  ///< L e^{2iθ}
  int bin = 0;                       ///< of ten degrees
};

/// Length and angle of a chord in the tangent plane; length 0 where the axis gives no direction.
Line chord(const Vec3& d, const Vec3& normal, const Vec3& axis) {
  if ((axis - normal * normal.dot(axis)).norm() < 0.1 * axis.norm()) return {};
  const Vec2 v = plane_frame(normal, axis).transpose() * d;
  const double length = v.norm(), angle = elementary::atan2(v.y(), v.x());
  const double turns = angle / pi;  // a direction repeats every half turn
  const int bin = std::min(17, static_cast<int>(18 * (turns - std::floor(turns))));
  return {length, angle, std::polar(length, 2 * angle), bin};
}

std::complex<double> doubled_sum(const std::vector<Line>& lines,
                                 const std::vector<double>& weights) {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    sum += weights[i] * lines[i].doubled;
  }
  return sum;
}

double total(const std::vector<Line>& lines, const std::vector<double>& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) sum += weights[i] * lines[i].length;
  return sum;
}

double entropy(const std::vector<Line>& lines, const std::vector<double>& weights) {
  std::array<double, 18> bins{};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    bins[lines[i].bin] += weights[i] * lines[i].length;
  }
  const double sum = total(lines, weights);
  double h = 0;
  for (const double b : bins) {
    if (b > 0) h -= b / sum * elementary::log(b / sum);
  }
  return h / elementary::log(18.0);
}

}  // namespace

Anisotropy measure_anisotropy(const CrackGraph& graph, const Vec3& axis, const Bootstrap& options) {
  std::vector<Line> lines, pieces;
  for (const CrackGraph::Edge& edge : graph.edges()) {
    if (edge.points.empty() || edge.border) continue;
    const Vec3& normal = edge.normals[edge.normals.size() / 2];
    const Line line = chord(edge.points.back() - edge.points.front(), normal, axis);
    if (line.length > 0) lines.push_back(line);
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      const Line piece = chord(edge.points[i] - edge.points[i - 1], edge.normals[i], axis);
      if (piece.length > 0) pieces.push_back(piece);
    }
  }
  Anisotropy a;
  if (lines.empty()) return a;
  a.strength = bootstrap(lines.size(), options, [&](const auto& w) {
    return std::abs(doubled_sum(lines, w)) / total(lines, w);
  });
  a.entropy = bootstrap(lines.size(), options, [&](const auto& w) { return entropy(lines, w); });
  const std::vector<double> ones(lines.size(), 1.0);
  double squares = 0;
  for (const Line& l : lines) squares += l.length * l.length;
  a.null.value = std::sqrt(squares) / total(lines, ones);
  const double mean = std::arg(doubled_sum(lines, ones)) / 2;
  a.direction = bootstrap(lines.size(), options, [&](const auto& w) {
    const double d = std::arg(doubled_sum(lines, w)) / 2 - mean;
    return (mean + d - pi * std::round(d / pi)) * 180 / pi;  // the branch nearest to the mean
  });
  if (a.direction.value < 0) a.direction.value += 180;
  if (a.direction.value >= 180) a.direction.value -= 180;
  double deviation = 0, length = 0;
  for (const Line& p : pieces) {
    const double d = p.angle - mean;
    const double off = d - pi * std::round(d / pi);
    deviation += p.length * off * off;
    length += p.length;
  }
  a.rms_deviation.value = std::sqrt(deviation / length) * 180 / pi;
  return a;
}

}  // namespace craze
