#include "craze/mesh/self_intersection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace craze {

namespace {

using Box = Eigen::AlignedBox3d;

/// Distances below this part of the triangles' size are rounding.
constexpr double rounding = 1e-9;

/// Six times the volume of a tetrahedron.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// Whether pq goes from one side of abc to the other through its inside.
bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c,
             double size) {
  const double tiny = rounding * size * size * size;
  const double above = volume(a, b, c, p), below = volume(a, b, c, q);
  if (!((above > tiny && below < -tiny) || (above < -tiny && below > tiny))) return false;
  const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
  return (u > tiny && v > tiny && w > tiny) || (u < -tiny && v < -tiny && w < -tiny);
}

class Triangles {
 public:
  Triangles(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles)
      : positions_(positions), triangles_(triangles) {}

  Box box(std::int32_t f) const {
    Box box;
    for (const std::int32_t v : triangles_[f]) box.extend(positions_[v]);
    return box;
  }

  bool cross(std::int32_t f, std::int32_t g) const {
    const Triangle &s = triangles_[f], &t = triangles_[g];
    bool shared[2][3] = {};
    int common = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (s[i] != t[j] && positions_[s[i]] != positions_[t[j]]) continue;
        shared[0][i] = shared[1][j] = true;
        ++common;
      }
    }
    if (common >= 2) return false;
    Box both = box(f);
    both.extend(box(g));
    const double size = both.diagonal().norm();
    return edges_pierce(s, shared[0], t, size) || edges_pierce(t, shared[1], s, size);
  }

 private:
  bool edges_pierce(const Triangle& edges, const bool* shared, const Triangle& t,
                    double size) const {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if (shared[i] || shared[j]) continue;
      if (pierces(positions_[edges[i]], positions_[edges[j]], positions_[t[0]], positions_[t[1]],
                  positions_[t[2]], size)) {
        return true;
      }
    }
    return false;
  }

  const std::vector<Vec3>& positions_;
  const std::vector<Triangle>& triangles_;
};

/// A tree of boxes over the triangles: node i has the children 2 i + 1 and 2 i + 2.
class BoxTree {
 public:
  BoxTree(const Triangles& triangles, std::size_t count) : order_(count) {
    std::iota(order_.begin(), order_.end(), 0);
    boxes_.reserve(count);
    for (std::size_t f = 0; f < count; ++f) {
      boxes_.push_back(triangles.box(static_cast<std::int32_t>(f)));
    }
    if (count > 0) build(0, 0, count);
  }

  /// Calls visit(f, g) for the pairs whose boxes touch, until it returns false.
  template <class Visit>
  void for_each_pair(Visit&& visit) const {
    if (!order_.empty()) within(0, visit);
  }

 private:
  static constexpr std::size_t leaf = 4;
  struct Node {
    Box box;
    std::size_t begin = 0, end = 0;
    bool is_leaf() const { return end - begin <= leaf; }
  };

  void build(std::size_t node, std::size_t begin, std::size_t end) {
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    Box box, centres;
    for (std::size_t i = begin; i < end; ++i) {
      box.extend(boxes_[order_[i]]);
      centres.extend(boxes_[order_[i]].center());
    }
    nodes_[node] = {box, begin, end};
    if (nodes_[node].is_leaf()) return;
    Eigen::Index axis = 0;
    centres.sizes().maxCoeff(&axis);
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::int32_t f, std::int32_t g) {
      const double a = boxes_[f].center()[axis], b = boxes_[g].center()[axis];
      return a != b ? a < b : f < g;
    });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
  }

  template <class Visit>
  bool within(std::size_t node, Visit& visit) const {
    if (nodes_[node].is_leaf()) return leaves(node, node, visit);
    return within(2 * node + 1, visit) && within(2 * node + 2, visit) &&
           between(2 * node + 1, 2 * node + 2, visit);
  }

  template <class Visit>
  bool between(std::size_t a, std::size_t b, Visit& visit) const {
    const Node &x = nodes_[a], &y = nodes_[b];
    if (!x.box.intersects(y.box)) return true;
    if (x.is_leaf() && y.is_leaf()) return leaves(a, b, visit);
    if (y.is_leaf() || (!x.is_leaf() && x.end - x.begin >= y.end - y.begin)) {
      return between(2 * a + 1, b, visit) && between(2 * a + 2, b, visit);
    }
    return between(a, 2 * b + 1, visit) && between(a, 2 * b + 2, visit);
  }

  template <class Visit>
  bool leaves(std::size_t a, std::size_t b, Visit& visit) const {
    for (std::size_t i = nodes_[a].begin; i < nodes_[a].end; ++i) {
      for (std::size_t j = a == b ? i + 1 : nodes_[b].begin; j < nodes_[b].end; ++j) {
        const auto [f, g] = std::minmax(order_[i], order_[j]);
        if (boxes_[f].intersects(boxes_[g]) && !visit(f, g)) return false;
      }
    }
    return true;
  }

  std::vector<std::int32_t> order_;
  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<std::array<std::int32_t, 2>> self_intersections(const std::vector<Vec3>& positions,
                                                            const std::vector<Triangle>& triangles,
                                                            std::size_t limit,
                                                            const Context& context) {
  constexpr std::int64_t pairs_between_polls = 1 << 15;
  std::int64_t seen = 0;
  std::vector<std::array<std::int32_t, 2>> pairs;
  const Triangles geometry(positions, triangles);
  BoxTree(geometry, triangles.size()).for_each_pair([&](std::int32_t f, std::int32_t g) {
    if (++seen % pairs_between_polls == 0) context.check();
    if (geometry.cross(f, g)) pairs.push_back({f, g});
    return pairs.size() < limit;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace craze
