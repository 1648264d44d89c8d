#include "craze/mesh/self_intersection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "craze/base/parallel.h"
#include "craze/base/simd.h"
#include "craze/mesh/crossing/triangles_cross.h"

namespace craze {

namespace {

/// A box in single precision. Rounding keeps the order of numbers, so that boxes that touch still
/// do.
struct Box {
  Vec4f low, high;  // the fourth number is 0

  Box() = default;
  Box(const std::vector<Vec3>& positions, const Triangle& t) {
    for (int k = 0; k < 3; ++k) {
      const double a = positions[t[0]][k], b = positions[t[1]][k], c = positions[t[2]][k];
      low[k] = static_cast<float>(std::min({a, b, c}));
      high[k] = static_cast<float>(std::max({a, b, c}));
    }
  }

  bool touches(const Box& other) const {
    using Words = long long __attribute__((vector_size(16)));
    const auto apart = (Words)((low.v > other.high.v) | (other.low.v > high.v));
    return (apart[0] | apart[1]) == 0;
  }
  void extend(const Box& other) {
    low.v = other.low.v < low.v ? other.low.v : low.v;
    high.v = other.high.v > high.v ? other.high.v : high.v;
  }
};

Eigen::AlignedBox3d exact_box(const std::vector<Vec3>& positions, const Triangle& t) {
  Eigen::AlignedBox3d box;
  for (const std::int32_t v : t) box.extend(positions[v]);
  return box;
}

}  // namespace

/// A tree of boxes over the triangles: node i has the children 2 i + 1 and 2 i + 2.
class SelfIntersections::BoxTree {
 public:
  /// Pairs of nodes; of a node with itself: the pairs within.
  struct Task {
    std::size_t a, b;
  };

  /// All have moved. `positions` stays where it is.
  BoxTree(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
          std::int32_t sheet_end)
      : positions_(positions),
        sheet_end_(sheet_end),
        order_(triangles.size()),
        slot_(triangles.size()),
        moved_(triangles.size(), 1),
        boxes_(triangles.size()) {
    std::vector<Centre> centres;
    centres.reserve(triangles.size());
    for (const Triangle& t : triangles) {
      const auto f = static_cast<std::int32_t>(centres.size());
      centres.push_back({exact_box(positions, t).center(), f});
    }
    if (!centres.empty()) build(centres, 0, 0, centres.size());
    for (std::size_t i = 0; i < centres.size(); ++i) order_[i] = centres[i].triangle;
    corners_.reserve(triangles.size());
    for (std::size_t i = 0; i < order_.size(); ++i) {
      slot_[order_[i]] = static_cast<std::int32_t>(i);
      corners_.push_back(triangles[order_[i]]);
    }
    fit();
  }

  bool has_moved(std::int32_t f) const { return moved_[slot_[f]] != 0; }

  /// Takes the boxes around vertices that have moved (#V) anew.
  void refit(const std::vector<char>& vertex_moved) {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const auto& [a, b, c] = corners_[i];
      moved_[i] = static_cast<char>(vertex_moved[a] | vertex_moved[b] | vertex_moved[c]);
    }
    fit();
  }

  /// What there is to do, in pieces: for_each_crossing() of one after the other meets all pairs of
  /// which one has moved, in one order.
  std::vector<Task> tasks() const {
    std::vector<Task> tasks;
    if (!order_.empty()) split(0, tasks);
    return tasks;
  }

  /// Calls visit(f, g), f < g, for the pairs that cross, until it returns false.
  template <class Visit>
  void for_each_crossing(const Task& task, Visit&& visit) const {
    if (task.a == task.b) {
      within(task.a, visit);
    } else {
      between(task.a, task.b, visit);
    }
  }

 private:
  static constexpr std::size_t leaf = 4, most_in_task = 2048;
  struct Node {
    Box box{};
    std::uint32_t begin = 0, end = 0;
    bool moved = true;  // something in it
    std::size_t size() const { return end - begin; }
    bool is_leaf() const { return size() <= leaf; }
  };

  struct Centre {
    Vec3 at;
    std::int32_t triangle;
  };

  void build(std::vector<Centre>& centres, std::size_t node, std::size_t begin, std::size_t end) {
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    nodes_[node].begin = static_cast<std::uint32_t>(begin);
    nodes_[node].end = static_cast<std::uint32_t>(end);
    if (nodes_[node].is_leaf()) return;
    Eigen::AlignedBox3d around;
    for (std::size_t i = begin; i < end; ++i) around.extend(centres[i].at);
    Eigen::Index axis = 0;
    around.sizes().maxCoeff(&axis);
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::size_t i) { return centres.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](const Centre& f, const Centre& g) {
      const double a = f.at[axis], b = g.at[axis];
      return a != b ? a < b : f.triangle < g.triangle;
    });
    build(centres, 2 * node + 1, begin, middle);
    build(centres, 2 * node + 2, middle, end);
  }

  /// The boxes of what has moved, and those around them.
  void fit() {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (moved_[i]) boxes_[i] = Box(positions_, corners_[i]);
    }
    for (std::size_t n = nodes_.size(); n-- > 0;) {
      Node& node = nodes_[n];
      if (node.size() == 0) continue;  // there is none
      if (node.is_leaf()) {
        node.moved = false;
        for (std::size_t i = node.begin; i < node.end; ++i) node.moved |= moved_[i] != 0;
        if (!node.moved) continue;
        node.box = boxes_[node.begin];
        for (std::size_t i = node.begin + 1; i < node.end; ++i) node.box.extend(boxes_[i]);
      } else {
        const Node &first = nodes_[2 * n + 1], &second = nodes_[2 * n + 2];
        node.moved = first.moved || second.moved;
        if (!node.moved) continue;
        node.box = first.box;
        node.box.extend(second.box);
      }
    }
  }

  bool apart(const Node& x, const Node& y) const {
    return !(x.moved || y.moved) || !x.box.touches(y.box);
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
      if (a != b && !boxes_[i].touches(nodes_[b].box)) continue;
      for (std::size_t j = a == b ? i + 1 : nodes_[b].begin; j < nodes_[b].end; ++j) {
        if (!(moved_[i] || moved_[j]) || !boxes_[i].touches(boxes_[j])) continue;
        const bool in_order = order_[i] < order_[j];
        if (in_order ? cross(i, j) : cross(j, i)) {
          if (!(in_order ? visit(order_[i], order_[j]) : visit(order_[j], order_[i]))) return false;
        }
      }
    }
    return true;
  }

  bool cross(std::size_t i, std::size_t j) const {
    const Triangle &s = corners_[i], &t = corners_[j];
    return triangles_cross(positions_, s, t, order_[i] < sheet_end_ && order_[j] < sheet_end_) &&
           exact_box(positions_, s).intersects(exact_box(positions_, t));
  }

  const std::vector<Vec3>& positions_;
  std::int32_t sheet_end_;
  std::vector<std::int32_t> order_, slot_;  // the triangles as the leaves have them; where each is
  // In that order:
  std::vector<char> moved_;  // since the pairs were last found
  std::vector<Triangle> corners_;
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
    for (std::size_t v = 0; v < positions.size(); ++v) {
      moved_[v] = positions_[v] != positions[v] ? 1 : 0;
      if (moved_[v]) positions_[v] = positions[v];
    }
    tree_->refit(moved_);
    find(false, context);
  }
  if (!knows_last || pairs_.size() >= limit_) {
    positions_ = positions;
    moved_.assign(positions.size(), 1);
    tree_ = std::make_unique<BoxTree>(positions_, triangles_, sheet_end_);
    find(true, context);
  }
  return pairs_;
}

void SelfIntersections::find(bool all, const Context& context) {
  constexpr std::size_t tasks_between_polls = 32;
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
      tree->for_each_crossing(tasks[begin + i], [&](std::int32_t f, std::int32_t g) {
        found[i].push_back({f, g});
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
