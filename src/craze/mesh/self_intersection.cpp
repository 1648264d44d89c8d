#include "craze/mesh/self_intersection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "craze/base/parallel.h"

namespace craze {

namespace {

using Box = Eigen::AlignedBox3d;

/// Distances below this part of the triangles' size are rounding.
constexpr double rounding = 1e-9;

/// Six times the volume of a tetrahedron.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// Whether pq goes from one side of abc to the other through its inside, or, where `through_ab`,
/// through ab.
bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c, double size,
             bool through_ab) {
  const double tiny = rounding * size * size * size;
  const double above = volume(a, b, c, p), below = volume(a, b, c, q);
  if (!((above > tiny && below < -tiny) || (above < -tiny && below > tiny))) return false;
  const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
  const double inside = through_ab ? -tiny : tiny;
  return (u > inside && v > tiny && w > tiny) || (u < -inside && v < -tiny && w < -tiny);
}

class Triangles {
 public:
  Triangles(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
            std::int32_t sheet_end)
      : positions_(positions), triangles_(triangles), sheet_end_(sheet_end) {}

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
    return edges_pierce(s, shared[0], t, shared[1], size) ||
           edges_pierce(t, shared[1], s, shared[0], size) ||
           (f < sheet_end_ && g < sheet_end_ && overlap(s, t, size));
  }

 private:
  Vec3 area_normal(const Triangle& t) const {
    const Vec3& a = positions_[t[0]];
    return (positions_[t[1]] - a).cross(positions_[t[2]] - a);
  }

  /// In one plane, turned the same way.
  bool overlap(const Triangle& s, const Triangle& t, double size) const {
    const Vec3 of_s = area_normal(s), of_t = area_normal(t);
    if (!(of_s.dot(of_t) > 0)) return false;
    const bool s_is_larger = of_s.squaredNorm() > of_t.squaredNorm();
    const Vec3 normal = (s_is_larger ? of_s : of_t).stableNormalized();
    const Triangle &large = s_is_larger ? s : t, &small = s_is_larger ? t : s;
    const Vec3& origin = positions_[large[0]];
    for (const std::int32_t v : small) {
      if (std::abs(normal.dot(positions_[v] - origin)) > rounding * size) return false;
    }
    return !edge_parts(s, t, normal, size) && !edge_parts(t, s, normal, size);
  }

  /// Whether t lies beyond an edge of s.
  bool edge_parts(const Triangle& s, const Triangle& t, const Vec3& normal, double size) const {
    for (int i = 0; i < 3; ++i) {
      const Vec3& from = positions_[s[i]];
      const Vec3 outwards = (positions_[s[(i + 1) % 3]] - from).cross(normal).stableNormalized();
      if (std::all_of(t.begin(), t.end(), [&](std::int32_t v) {
            return outwards.dot(positions_[v] - from) >= -rounding * size;
          })) {
        return true;
      }
    }
    return false;
  }

  /// Edges opposite a shared corner that meet are one way to it from inside both triangles.
  bool edges_pierce(const Triangle& edges, const bool* shared, const Triangle& t,
                    const bool* t_shared, double size) const {
    int last = 2;
    while (last > 0 && !t_shared[last]) --last;
    const bool share = t_shared[last];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if (shared[i] || shared[j]) continue;
      if (pierces(positions_[edges[i]], positions_[edges[j]], positions_[t[(last + 1) % 3]],
                  positions_[t[(last + 2) % 3]], positions_[t[last]], size, share)) {
        return true;
      }
    }
    return false;
  }

  const std::vector<Vec3>& positions_;
  const std::vector<Triangle>& triangles_;
  std::int32_t sheet_end_;
};

}  // namespace

/// A tree of boxes over the triangles: node i has the children 2 i + 1 and 2 i + 2.
class SelfIntersections::BoxTree {
 public:
  /// Pairs of nodes; of a node with itself: the pairs within.
  struct Task {
    std::size_t a, b;
  };

  BoxTree(const Triangles& triangles, std::size_t count) : order_(count), moved_(count, 1) {
    std::iota(order_.begin(), order_.end(), 0);
    boxes_.reserve(count);
    for (std::size_t f = 0; f < count; ++f) {
      boxes_.push_back(triangles.box(static_cast<std::int32_t>(f)));
    }
    if (count > 0) build(0, 0, count);
  }

  bool has_moved(std::int32_t f) const { return moved_[f] != 0; }

  /// Takes the boxes of the triangles that have moved (#F) anew, and those around them.
  void refit(const Triangles& triangles, std::vector<char> moved) {
    moved_ = std::move(moved);
    for (std::size_t f = 0; f < moved_.size(); ++f) {
      if (moved_[f]) boxes_[f] = triangles.box(static_cast<std::int32_t>(f));
    }
    for (std::size_t i = nodes_.size(); i-- > 0;) {
      Node& node = nodes_[i];
      if (node.is_leaf()) {
        node.moved = std::any_of(at(node.begin), at(node.end),
                                 [&](std::int32_t f) { return moved_[f] != 0; });
        if (!node.moved) continue;
        node.box.setEmpty();
        for (std::size_t k = node.begin; k < node.end; ++k) node.box.extend(boxes_[order_[k]]);
      } else {
        const Node &first = nodes_[2 * i + 1], &second = nodes_[2 * i + 2];
        node.moved = first.moved || second.moved;
        if (node.moved) node.box = first.box.merged(second.box);
      }
    }
  }

  /// What there is to do, in pieces: for_each_pair() of one after the other meets all pairs of
  /// which one has moved, in one order.
  std::vector<Task> tasks() const {
    std::vector<Task> tasks;
    if (!order_.empty()) split(0, tasks);
    return tasks;
  }

  /// Calls visit(f, g) for the pairs whose boxes touch, until it returns false.
  template <class Visit>
  void for_each_pair(const Task& task, Visit&& visit) const {
    if (task.a == task.b) {
      within(task.a, visit);
    } else {
      between(task.a, task.b, visit);
    }
  }

 private:
  static constexpr std::size_t leaf = 4, most_in_task = 2048;
  struct Node {
    Box box;
    std::size_t begin = 0, end = 0;
    bool moved = true;  // something in it
    std::size_t size() const { return end - begin; }
    bool is_leaf() const { return size() <= leaf; }
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
    std::nth_element(at(begin), at(middle), at(end), [&](std::int32_t f, std::int32_t g) {
      const double a = boxes_[f].center()[axis], b = boxes_[g].center()[axis];
      return a != b ? a < b : f < g;
    });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
  }

  std::vector<std::int32_t>::iterator at(std::size_t i) {
    return order_.begin() + static_cast<std::ptrdiff_t>(i);
  }

  bool apart(const Node& x, const Node& y) const {
    return !(x.moved || y.moved) || !x.box.intersects(y.box);
  }
  /// Which of two nodes, not both of them leaves, falls into its halves.
  static bool first_is_split(const Node& x, const Node& y) {
    return y.is_leaf() || (!x.is_leaf() && x.size() >= y.size());
  }

  void split(std::size_t node, std::vector<Task>& tasks) const {
    if (!nodes_[node].moved) return;
    if (nodes_[node].size() <= most_in_task) {
      tasks.push_back({node, node});
      return;
    }
    split(2 * node + 1, tasks);
    split(2 * node + 2, tasks);
    split(2 * node + 1, 2 * node + 2, tasks);
  }

  void split(std::size_t a, std::size_t b, std::vector<Task>& tasks) const {
    const Node &x = nodes_[a], &y = nodes_[b];
    if (apart(x, y)) return;
    if (x.size() <= most_in_task && y.size() <= most_in_task) {
      tasks.push_back({a, b});
    } else if (first_is_split(x, y)) {
      split(2 * a + 1, b, tasks);
      split(2 * a + 2, b, tasks);
    } else {
      split(a, 2 * b + 1, tasks);
      split(a, 2 * b + 2, tasks);
    }
  }

  template <class Visit>
  bool within(std::size_t node, Visit& visit) const {
    if (!nodes_[node].moved) return true;
    if (nodes_[node].is_leaf()) return leaves(node, node, visit);
    return within(2 * node + 1, visit) && within(2 * node + 2, visit) &&
           between(2 * node + 1, 2 * node + 2, visit);
  }

  template <class Visit>
  bool between(std::size_t a, std::size_t b, Visit& visit) const {
    const Node &x = nodes_[a], &y = nodes_[b];
    if (apart(x, y)) return true;
    if (x.is_leaf() && y.is_leaf()) return leaves(a, b, visit);
    if (first_is_split(x, y)) {
      return between(2 * a + 1, b, visit) && between(2 * a + 2, b, visit);
    }
    return between(a, 2 * b + 1, visit) && between(a, 2 * b + 2, visit);
  }

  template <class Visit>
  bool leaves(std::size_t a, std::size_t b, Visit& visit) const {
    for (std::size_t i = nodes_[a].begin; i < nodes_[a].end; ++i) {
      if (a != b && !boxes_[order_[i]].intersects(nodes_[b].box)) continue;
      for (std::size_t j = a == b ? i + 1 : nodes_[b].begin; j < nodes_[b].end; ++j) {
        const std::int32_t f = std::min(order_[i], order_[j]), g = std::max(order_[i], order_[j]);
        if (!moved_[f] && !moved_[g]) continue;
        if (boxes_[f].intersects(boxes_[g]) && !visit(f, g)) return false;
      }
    }
    return true;
  }

  std::vector<std::int32_t> order_;
  std::vector<char> moved_;  // #F: since the pairs were last found
  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
};

SelfIntersections::SelfIntersections(const std::vector<Triangle>& triangles, std::size_t limit,
                                     std::int32_t sheet_end)
    : triangles_(triangles), limit_(limit), sheet_end_(sheet_end) {}

SelfIntersections::~SelfIntersections() = default;

const SelfIntersections::Pairs& SelfIntersections::at(const std::vector<Vec3>& positions,
                                                      const Context& context) {
  // Of more pairs than the limit not all are known, and which ones hangs on the tree.
  const bool knows_last = tree_ && pairs_.size() < limit_;
  if (knows_last) {
    std::vector<char> vertex_moved(positions.size()), moved(triangles_.size(), 0);
    for (std::size_t v = 0; v < positions.size(); ++v) {
      vertex_moved[v] = positions_[v] != positions[v] ? 1 : 0;
    }
    for (std::size_t f = 0; f < moved.size(); ++f) {
      for (const std::int32_t v : triangles_[f]) moved[f] |= vertex_moved[v];
    }
    positions_ = positions;
    tree_->refit({positions_, triangles_, sheet_end_}, std::move(moved));
    find(false, context);
  }
  if (!knows_last || pairs_.size() >= limit_) {
    positions_ = positions;
    tree_ =
        std::make_unique<BoxTree>(Triangles{positions_, triangles_, sheet_end_}, triangles_.size());
    find(true, context);
  }
  return pairs_;
}

void SelfIntersections::find(bool all, const Context& context) {
  constexpr std::size_t tasks_between_polls = 32;
  const Triangles geometry(positions_, triangles_, sheet_end_);
  std::unique_ptr<BoxTree> tree = std::move(tree_);  // gone where it is cancelled
  const std::vector<BoxTree::Task> tasks = tree->tasks();
  Pairs kept;
  if (!all) {
    std::copy_if(pairs_.begin(), pairs_.end(), std::back_inserter(kept), [&](const auto& pair) {
      return !tree->has_moved(pair[0]) && !tree->has_moved(pair[1]);
    });
  }
  pairs_ = std::move(kept);
  std::array<Pairs, tasks_between_polls> found;
  for (std::size_t begin = 0; begin < tasks.size() && pairs_.size() < limit_;
       begin += tasks_between_polls) {
    context.check();
    const std::size_t count = std::min(tasks_between_polls, tasks.size() - begin);
    parallel_for(context.threads, count, 1, [&](std::size_t i, std::size_t) {
      found[i].clear();
      tree->for_each_pair(tasks[begin + i], [&](std::int32_t f, std::int32_t g) {
        if (geometry.cross(f, g)) found[i].push_back({f, g});
        return found[i].size() < limit_;
      });
    });
    for (std::size_t i = 0; i < count; ++i) {
      pairs_.insert(pairs_.end(), found[i].begin(), found[i].end());
    }
  }
  if (pairs_.size() > limit_) pairs_.resize(limit_);
  std::sort(pairs_.begin(), pairs_.end());
  tree_ = std::move(tree);
}

std::vector<std::array<std::int32_t, 2>> self_intersections(const std::vector<Vec3>& positions,
                                                            const std::vector<Triangle>& triangles,
                                                            std::size_t limit,
                                                            const Context& context) {
  return SelfIntersections(triangles, limit).at(positions, context);
}

}  // namespace craze
