#include "craze/products/faces/wall_rows.h"

#include <cstddef>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace craze {

namespace {

class RowBuilder {
 public:
  RowBuilder(const OpenedMesh& opened, const std::vector<std::int32_t>& column, std::int32_t tops,
             int rows)
      : opened_(opened),
        column_(column),
        tops_(tops),
        rows_(rows),
        first_(static_cast<std::int32_t>(opened.mesh.positions.size())) {}

  void divide(std::int32_t face) {
    const Triangle& t = opened_.mesh.triangles[face];
    // The corner that is a top or a bottom alone.
    std::size_t apex = 0;
    while (is_top(t[apex]) == is_top(t[(apex + 1) % 3]) ||
           is_top(t[apex]) == is_top(t[(apex + 2) % 3])) {
      ++apex;
    }
    const std::int32_t tip = t[apex], next = t[(apex + 1) % 3], last = t[(apex + 2) % 3];
    if (is_top(tip)) {
      strip(edge(tip, next), edge(tip, last), face);
    } else {
      strip(edge(last, tip), edge(next, tip), face);
      belongs_below(last, tip, next);
      belongs_below(next, tip, last);
    }
  }

  WallRows take() { return std::move(made_); }

 private:
  struct Edge {
    std::int32_t top, bottom, first;
  };

  bool is_top(std::int32_t v) const { return v < tops_; }

  Edge edge(std::int32_t top, std::int32_t bottom) {
    const auto key = static_cast<std::uint64_t>(top) << 32 | static_cast<std::uint32_t>(bottom);
    const auto next = first_ + static_cast<std::int32_t>(made_.points.size());
    const auto [found, is_new] = first_of_.emplace(key, next);
    for (int k = 1; is_new && k < rows_; ++k) {
      made_.points.push_back({top, bottom, static_cast<double>(k) / rows_, Vec3::Zero()});
      made_.vertex.push_back(opened_.vertex_of[top]);
    }
    return {top, bottom, found->second};
  }
  std::int32_t on(const Edge& e, int k) const {
    if (k == 0) return e.top;
    return k == rows_ ? e.bottom : e.first + k - 1;
  }

  /// The lower half of a slanting edge lies below the other top.
  void belongs_below(std::int32_t top, std::int32_t bottom, std::int32_t other) {
    if (column_[bottom] != column_[other] || column_[bottom] == column_[top]) return;
    const Edge e = edge(top, bottom);
    for (int k = rows_ / 2 + 1; k < rows_; ++k) made_.vertex[on(e, k) - first_] = other;
  }

  /// From p, downwards, towards q.
  void strip(const Edge& p, const Edge& q, std::int32_t face) {
    const auto order = [&](const Edge& e) {
      return std::tuple(column_[e.top] != column_[e.bottom], column_[e.top], column_[e.bottom]);
    };
    const bool from_p = order(p) < order(q);
    for (int k = 0; k < rows_; ++k) {
      const std::int32_t a = on(p, k), b = on(p, k + 1), c = on(q, k + 1), d = on(q, k);
      if (from_p) {
        add({a, b, c}, face);
        add({a, c, d}, face);
      } else {
        add({a, b, d}, face);
        add({b, c, d}, face);
      }
    }
  }

  void add(const Triangle& t, std::int32_t face) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    made_.triangles.push_back(t);
    made_.parent.push_back(face);
  }

  const OpenedMesh& opened_;
  const std::vector<std::int32_t>& column_;
  std::int32_t tops_;
  int rows_;
  std::int32_t first_;
  std::unordered_map<std::uint64_t, std::int32_t> first_of_;
  WallRows made_;
};

}  // namespace

WallRows wall_rows(const OpenedMesh& opened, std::int32_t begin, std::int32_t end,
                   const std::vector<std::int32_t>& column, std::int32_t tops, int rows) {
  RowBuilder builder(opened, column, tops, rows);
  for (std::int32_t f = begin; f < end; ++f) builder.divide(f);
  return builder.take();
}

}  // namespace craze
