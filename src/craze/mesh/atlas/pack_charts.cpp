#include "craze/mesh/atlas/pack_charts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "craze/base/elementary.h"

namespace craze {

namespace {

constexpr int turns_tried = 16;  // in a right angle
constexpr double widest_gap = 1.0 / 256;
constexpr double growth = 1.02;  // of the square, until all find room

struct Box {
  Vec2 low, high;
  Vec2 size() const { return high - low; }
};

template <class Turn>
Box box_of(const AtlasChart& chart, Turn&& turned) {
  Box box{Vec2::Constant(INFINITY), Vec2::Constant(-INFINITY)};
  for (const auto& corners : chart.corners) {
    for (const Vec2& p : corners) {
      const Vec2 q = turned(p);
      box = {box.low.cwiseMin(q), box.high.cwiseMax(q)};
    }
  }
  return box;
}

/// Turns a chart to where its box is smallest and wider than high, and moves that to the origin.
Vec2 straighten(AtlasChart& chart) {
  constexpr double right_angle = 1.5707963267948966;
  Mat2 best = Mat2::Identity();
  double least = INFINITY;
  for (int k = 0; k < turns_tried; ++k) {
    const double angle = right_angle * k / turns_tried;
    const double c = elementary::cos(angle), s = elementary::sin(angle);
    Mat2 turn;
    turn << c, -s, s, c;
    const Vec2 size = box_of(chart, [&](const Vec2& p) -> Vec2 { return turn * p; }).size();
    if (size.prod() >= least) continue;
    least = size.prod();
    Mat2 upright;
    upright << 0, -1, 1, 0;
    best = size.x() >= size.y() ? turn : Mat2(upright * turn);
  }
  const Box box = box_of(chart, [&](const Vec2& p) -> Vec2 { return best * p; });
  for (auto& corners : chart.corners) {
    for (Vec2& p : corners) p = best * p - box.low;
  }
  return box.size();
}

/// Rows of boxes from the bottom up, the highest first. False where a square of that side has no
/// room.
bool place_in_rows(const std::vector<Vec2>& sizes, const std::vector<std::size_t>& order,
                   double side, double gap, std::vector<Vec2>& places) {
  double x = gap, y = gap, row = 0;
  for (const std::size_t i : order) {
    if (x + sizes[i].x() + gap > side) {
      x = gap;
      y += row + gap;
      row = 0;
    }
    if (x + sizes[i].x() + gap > side || y + sizes[i].y() + gap > side) return false;
    places[i] = {x, y};
    x += sizes[i].x() + gap;
    row = std::max(row, sizes[i].y());
  }
  return true;
}

}  // namespace

void pack_charts(std::vector<AtlasChart>& charts, const Context& context) {
  if (charts.empty()) return;
  std::vector<Vec2> sizes, places(charts.size());
  double area = 0, widest = 0;
  for (AtlasChart& chart : charts) {
    sizes.push_back(straighten(chart));
    area += sizes.back().prod();
    widest = std::max(widest, sizes.back().x());
  }
  context.check();
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return sizes[i].y() > sizes[j].y(); });
  const double gap = std::min(widest_gap, 0.25 / std::sqrt(static_cast<double>(charts.size())));
  double side = std::max(std::sqrt(area), widest);
  while (!place_in_rows(sizes, order, side, gap * side, places)) side *= growth;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    for (auto& corners : charts[i].corners) {
      for (Vec2& p : corners) p = (p + places[i]) / side;
    }
  }
}

}  // namespace craze
