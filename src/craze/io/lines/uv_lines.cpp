#include "craze/io/lines/uv_lines.h"

#include <algorithm>

namespace craze {

namespace {

/// How far apart the ends of two joined edges may lie, of the texture's side: rounding.
constexpr double apart = 1e-9;

/// The places in the texture of each point of the lines: more than one on a seam.
class SplitPoints {
 public:
  SplitPoints(std::size_t points, UvLines& to) : first_(points, -1), to_(to) {}

  std::int32_t at(std::int32_t point, std::int32_t island, const Vec2& uv) {
    for (std::int32_t p = first_[point]; p >= 0; p = next_[p]) {
      const Vec3& known = to_.lines.points[p];
      const double d = std::max(std::abs(known.x() - uv.x()), std::abs(known.y() - uv.y()));
      if (to_.island[p] == island && d <= apart) return p;
    }
    const auto p = static_cast<std::int32_t>(next_.size());
    to_.lines.points.emplace_back(uv.x(), uv.y(), 0);
    to_.island.push_back(island);
    next_.push_back(first_[point]);
    return first_[point] = p;
  }

 private:
  std::vector<std::int32_t> first_;  // per point of the lines: its last split point, −1: none
  std::vector<std::int32_t> next_;   // per split point: another one of the same point
  UvLines& to_;
};

}  // namespace

UvLines uv_lines(const LineSet& lines) {
  UvLines result;
  const Attribute* islands = find_attribute(lines.edge_attributes, "uv_island");
  SplitPoints points(lines.points.size(), result);
  for (std::size_t e = 0; e < lines.edges.size(); ++e) {
    const auto& [a, b] = lines.edges[e];
    const Vec2 &uv_a = lines.uvs[2 * e], &uv_b = lines.uvs[2 * e + 1];
    const std::int32_t island = islands ? static_cast<std::int32_t>(islands->values[e]) : 0;
    if (island < 0 || (uv_a == uv_b && lines.points[a] != lines.points[b])) {
      ++result.left_out;
      continue;
    }
    const std::int32_t from = points.at(a, island, uv_a), to = points.at(b, island, uv_b);
    result.lines.edges.push_back({from, to});
  }
  return result;
}

}  // namespace craze
