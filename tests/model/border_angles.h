// At which angle cracks meet the border of a plate.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "craze/model/crack_network.h"

namespace craze::test {

/// Points on a crack from a node of degree one on the border inward, up to `reach` away.
inline std::vector<Vec3> follow_inward(const CrackNetwork& network, std::int32_t start,
                                       double reach) {
  std::vector<Vec3> points{network.nodes[start].position};
  std::int32_t at = start, from = -1;
  while ((network.nodes[at].position - points.front()).norm() < reach) {
    std::int32_t onward = -1;
    int ways = 0;
    for (const CrackEdge& e : network.edges) {
      const std::int32_t other = e.a == at ? e.b : e.b == at ? e.a : -1;
      if (other < 0 || other == from) continue;
      onward = other;
      ++ways;
    }
    if (ways != 1) break;  // a tip, or another crack
    from = at;
    at = onward;
    points.push_back(network.nodes[at].position);
  }
  return points;
}

/// The direction of the line fitted to the points.
inline Vec3 fitted_direction(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Mat3 scatter = Mat3::Zero();
  for (const Vec3& p : points) scatter += (p - mean) * (p - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Mat3>(scatter).eigenvectors().col(2);
}

/// Degrees off the border's normal, signed, of the cracks that end on the border of a unit plate
/// centred at the origin, measured over `reach` and farther than `margin` from the corners.
inline std::vector<double> border_angles(const CrackNetwork& network, double reach, double margin) {
  std::vector<double> angles;
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    const Vec3& at = network.nodes[n].position;
    if (network.nodes[n].kind != JunctionKind::border) continue;
    if (std::min(std::abs(at.x()), std::abs(at.y())) > 0.5 - margin) continue;
    const std::vector<Vec3> points = follow_inward(network, static_cast<std::int32_t>(n), reach);
    if ((points.back() - at).norm() < 0.7 * reach) continue;
    const Vec3 inward = std::abs(at.x()) > std::abs(at.y()) ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 direction = fitted_direction(points);
    const double cosine = direction.dot(inward);
    const double sine = direction.cross(inward).z() * (cosine < 0 ? -1 : 1);
    angles.push_back(std::asin(std::clamp(sine, -1.0, 1.0)) * 180 / std::numbers::pi);
  }
  return angles;
}

}  // namespace craze::test
