#include "craze/mesh/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace craze {

namespace {

constexpr std::int32_t leaf_size = 4;

double squared_distance(const Eigen::AlignedBox3d& box, const Vec3& p) {
  return (box.min() - p).cwiseMax(p - box.max()).cwiseMax(0.0).squaredNorm();
}

}  // namespace

Vec3 nearest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double t = d1 / (d1 - d3);
    return {1 - t, t, 0};
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double t = d2 / (d2 - d6);
    return {1 - t, 0, t};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - t, t};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

ClosestPoint::ClosestPoint(const std::vector<Vec3>& positions,
                           const std::vector<Triangle>& triangles, std::vector<std::int32_t> labels)
    : positions_(positions), triangles_(triangles), labels_(std::move(labels)) {
  normals_.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    const Vec3& a = positions[t[0]];
    normals_.emplace_back((positions[t[1]] - a).cross(positions[t[2]] - a).normalized());
  }
  build();
}

void ClosestPoint::build() {
  if (triangles_.empty()) return;
  struct Centre {
    Vec3 at;
    std::int32_t face;
  };
  std::vector<Centre> centres;
  centres.reserve(triangles_.size());
  for (const Triangle& t : triangles_) {
    centres.push_back({(positions_[t[0]] + positions_[t[1]] + positions_[t[2]]) / 3,
                       static_cast<std::int32_t>(centres.size())});
  }
  nodes_.push_back({0, static_cast<std::int32_t>(centres.size())});
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const std::int32_t first = nodes_[n].first, count = nodes_[n].count;
    const auto begin = centres.begin() + first, end = begin + count;
    if (count <= leaf_size) {
      // In one order, whatever nth_element left: of equally near faces the first is found.
      std::sort(begin, end, [](const Centre& f, const Centre& g) { return f.face < g.face; });
      continue;
    }
    Eigen::AlignedBox3d around;
    for (auto centre = begin; centre != end; ++centre) around.extend(centre->at);
    Eigen::Index axis = 0;
    around.sizes().maxCoeff(&axis);
    const std::int32_t half = count / 2;
    std::nth_element(begin, begin + half, end, [&](const Centre& f, const Centre& g) {
      const double x = f.at[axis], y = g.at[axis];
      return x < y || (x == y && f.face < g.face);
    });
    nodes_[n].first = static_cast<std::int32_t>(nodes_.size());
    nodes_[n].count = 0;
    nodes_.push_back({first, half});
    nodes_.push_back({first + half, count - half});
  }
  order_.reserve(centres.size());
  for (const Centre& centre : centres) order_.push_back(centre.face);
  fit();
}

void ClosestPoint::fit() {
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    if (node.count == 0) {  // its children come after it
      node.box = nodes_[node.first].box;
      node.box.extend(nodes_[node.first + 1].box);
      node.normals = nodes_[node.first].normals;
      node.normals.extend(nodes_[node.first + 1].normals);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      for (const std::int32_t v : triangles_[order_[i]]) node.box.extend(positions_[v]);
      node.normals.extend(normals_[order_[i]]);
    }
  }
}

/// Whether any normal in the node's box has the filter's cosine.
bool ClosestPoint::may_accept(const Node& node, const Filter& filter) {
  constexpr double roundings = 1e-12;
  const Vec3 most = (node.normals.min().cwiseProduct(filter.normal))
                        .cwiseMax(node.normals.max().cwiseProduct(filter.normal));
  return most.sum() >= filter.least - roundings;
}

void ClosestPoint::improve(Hit& best, std::int32_t f, const Vec3& point) const {
  const Triangle& t = triangles_[f];
  const Vec3 &a = positions_[t[0]], &b = positions_[t[1]], &c = positions_[t[2]];
  const Vec3 w = nearest_weights(point, a, b, c);
  const Vec3 at = w[0] * a + w[1] * b + w[2] * c;
  const double distance = (at - point).squaredNorm();
  if (distance < best.distance) best = {f, w, at, distance};
}

ClosestPoint::Hit ClosestPoint::find(const Vec3& point, const Filter& filter) const {
  // Its distance is squared until the end.
  Hit best{-1, Vec3::Zero(), point, filter.farthest * filter.farthest};
  if (nodes_.empty()) return best;
  if (filter.hint >= 0 && accepts(filter.hint, filter)) improve(best, filter.hint, point);
  struct Entry {
    std::int32_t node;
    double distance;
  };
  std::array<Entry, 128> stack;  // two entries per level of a balanced tree of at most 2³¹ faces
  std::size_t top = 0;
  stack[top++] = {0, squared_distance(nodes_[0].box, point)};
  const double enough = filter.enough * filter.enough;
  while (top > 0 && best.distance > enough) {
    const Entry e = stack[--top];
    if (e.distance >= best.distance) continue;
    const Node& node = nodes_[e.node];
    if (!may_accept(node, filter)) continue;
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      if (accepts(order_[i], filter)) improve(best, order_[i], point);
    }
    if (node.count > 0) continue;
    Entry near{node.first, 0}, far{node.first + 1, 0};
    near.distance = squared_distance(nodes_[near.node].box, point);
    far.distance = squared_distance(nodes_[far.node].box, point);
    if (far.distance < near.distance) std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
  best.distance = std::sqrt(best.distance);
  return best;
}

}  // namespace craze
