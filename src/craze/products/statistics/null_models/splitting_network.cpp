#include <algorithm>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include "craze/base/elementary.h"
#include "craze/base/random.h"
#include "craze/products/statistics/graph/clipped_network.h"
#include "craze/products/statistics/null_models/null_networks.h"

namespace craze {
namespace {

/// A corner of a convex cell, and the cut (0 … 3: a side of the window) along the side leaving it.
struct Corner {
  Vec2 p;
  std::int32_t cut;
};
using Polygon = std::vector<Corner>;

/// A window that is cut into convex cells, one straight cut after the other.
class Splitter {
 public:
  explicit Splitter(double side) {
    const Vec2 c[4] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    Polygon window;
    for (int i = 0; i < 4; ++i) {
      window.push_back({c[i], i});
      cuts_.push_back({c[i], c[(i + 1) % 4] - c[i], {}});
    }
    cells.push_back(window);
  }

  /// Cuts a cell along the line through p; the line must cross two of its sides. The half on the
  /// line's left stays, the other is appended.
  void split(std::size_t index, const Vec2& p, const Vec2& direction) {
    const Polygon cell = cells[index];
    const Vec2 left(-direction.y(), direction.x());
    const auto id = static_cast<std::int32_t>(cuts_.size());
    Polygon half[2];  // left, right
    std::vector<std::pair<Vec2, std::int32_t>> ends;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Corner& a = cell[i];
      const Corner& b = cell[(i + 1) % cell.size()];
      const double da = left.dot(a.p - p), db = left.dot(b.p - p);
      const bool right_a = da < 0, right_b = db < 0;
      half[right_a].push_back(a);
      if (right_a == right_b) continue;
      const Vec2 q = a.p + da / (da - db) * (b.p - a.p);
      half[right_a].push_back({q, id});  // from here on the half runs along the new cut
      half[right_b].push_back({q, a.cut});
      ends.emplace_back(q, a.cut);
    }
    cuts_.push_back({ends[0].first, ends[1].first - ends[0].first, {}});
    for (const auto& [q, across] : ends) {
      const auto node = static_cast<std::int32_t>(network_.nodes.size());
      network_.nodes.push_back({{q.x(), q.y(), 0},
                                Vec3::UnitZ(),
                                -1,
                                across < 4 ? JunctionKind::border : JunctionKind::bend});
      cuts_[id].attach(q, node);
      cuts_[across].attach(q, node);
    }
    cells[index] = half[0];
    cells.push_back(half[1]);
  }

  CrackNetwork take() {
    for (std::size_t c = 4; c < cuts_.size(); ++c) {
      std::sort(cuts_[c].nodes.begin(), cuts_[c].nodes.end());
      for (std::size_t k = 1; k < cuts_[c].nodes.size(); ++k) {
        CrackEdge edge;
        edge.a = cuts_[c].nodes[k - 1].second;
        edge.b = cuts_[c].nodes[k].second;
        edge.event = static_cast<std::int32_t>(c) - 4;
        edge.time = static_cast<double>(edge.event);
        network_.edges.push_back(edge);
      }
    }
    set_kinds(network_);
    return std::move(network_);
  }

  std::vector<Polygon> cells;

 private:
  struct Cut {
    Vec2 start, along;
    std::vector<std::pair<double, std::int32_t>> nodes;  // position along the cut, node
    void attach(const Vec2& p, std::int32_t node) {
      nodes.emplace_back(along.dot(p - start), node);
    }
  };
  std::vector<Cut> cuts_;
  CrackNetwork network_;
};

}  // namespace

CrackNetwork orthogonal_network(double side, std::int32_t cells, double low, double high,
                                std::uint64_t seed) {
  Random random(seed, 0x6f727468);  // "orth"
  Splitter splitter(side);
  std::priority_queue<std::pair<double, std::size_t>> by_area;
  const auto extent = [&](std::size_t i) {
    Vec2 a = splitter.cells[i][0].p, b = a;
    for (const Corner& c : splitter.cells[i]) {
      a = a.cwiseMin(c.p);
      b = b.cwiseMax(c.p);
    }
    return std::pair{a, b};
  };
  const auto push = [&](std::size_t i) {
    const auto [a, b] = extent(i);
    by_area.emplace((b - a).prod(), i);
  };
  push(0);
  while (static_cast<std::int32_t>(splitter.cells.size()) < cells) {
    const std::size_t i = by_area.top().second;
    by_area.pop();
    const auto [a, b] = extent(i);
    const bool wide = b.x() - a.x() > b.y() - a.y();
    splitter.split(i, a + random.uniform(low, high) * (b - a), wide ? Vec2(0, 1) : Vec2(1, 0));
    push(i);
    push(splitter.cells.size() - 1);
  }
  return splitter.take();
}

CrackNetwork stit_network(double side, std::int32_t cells, std::uint64_t seed) {
  Random random(seed, 0x73746974);  // "stit"
  Splitter splitter(side);
  // Cells by the time at which they are cut, earliest first.
  std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>,
                      std::greater<>>
      by_time;
  const auto push = [&](double now, std::size_t i) {
    const Polygon& cell = splitter.cells[i];
    double perimeter = 0;
    for (std::size_t k = 0; k < cell.size(); ++k) {
      perimeter += (cell[(k + 1) % cell.size()].p - cell[k].p).norm();
    }
    by_time.emplace(now - elementary::log(1 - random.uniform()) / perimeter, i);
  };
  push(0, 0);
  while (static_cast<std::int32_t>(splitter.cells.size()) < cells) {
    const auto [now, i] = by_time.top();
    by_time.pop();
    // A uniform random line that hits the cell: its normal's angle has a density proportional to
    // the cell's width in that direction, at most the diameter.
    const Polygon& cell = splitter.cells[i];
    double diameter = 0;
    for (const Corner& a : cell) {
      for (const Corner& b : cell) diameter = std::max(diameter, (a.p - b.p).norm());
    }
    for (;;) {
      const double angle = random.uniform(0, std::numbers::pi);
      const Vec2 normal(elementary::cos(angle), elementary::sin(angle));
      double low = normal.dot(cell[0].p), high = low;
      for (const Corner& c : cell) {
        low = std::min(low, normal.dot(c.p));
        high = std::max(high, normal.dot(c.p));
      }
      const double offset = low + random.uniform() * diameter;
      if (offset >= high) continue;
      splitter.split(i, offset * normal, {-normal.y(), normal.x()});
      break;
    }
    push(now, i);
    push(now, splitter.cells.size() - 1);
  }
  return splitter.take();
}

}  // namespace craze
