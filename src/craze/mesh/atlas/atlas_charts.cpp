#include "craze/mesh/atlas/atlas_charts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <utility>

#include "craze/mesh/atlas/uv_atlas.h"

namespace craze {

namespace {

constexpr std::size_t charts_between_polls = 256;

using Corners = std::array<Vec2, 3>;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

/// Whether all corners of q lie on the outer side of an edge of p, or on it.
bool is_beside(const Corners& p, const Corners& q) {
  // Shared edges are the same numbers; what rounding makes of others is far below this.
  constexpr double rounding = 1e-12;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % 3];
    const double length = (b - a).norm();
    const bool all = std::all_of(q.begin(), q.end(), [&](const Vec2& c) {
      return turn(a, b, c) <= rounding * length * ((c - a).norm() + length);
    });
    if (all) return true;
  }
  return false;
}

bool overlap(const Corners& p, const Corners& q) {
  return !is_beside(p, q) && !is_beside(q, p);
}

/// The triangles of a chart by the cells of a grid that they lie in.
class LaidTriangles {
 public:
  explicit LaidTriangles(double cell) : cell_(cell) {}

  bool has_room_for(const Corners& t) const {
    for (const std::size_t i : large_) {
      if (overlap(all_[i], t)) return false;
    }
    bool free = true;
    const bool is_small = for_each_cell(t, [&](const Cell& cell) {
      const auto found = cells_.find(cell);
      if (!free || found == cells_.end()) return;
      for (const std::size_t i : found->second) free = free && !overlap(all_[i], t);
    });
    if (is_small) return free;
    return std::none_of(all_.begin(), all_.end(),
                        [&](const Corners& other) { return overlap(other, t); });
  }

  void add(const Corners& t) {
    const std::size_t i = all_.size();
    all_.push_back(t);
    if (!for_each_cell(t, [&](const Cell& cell) { cells_[cell].push_back(i); })) {
      large_.push_back(i);
    }
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;

  /// False, and no visit, where there are too many.
  template <class Visit>
  bool for_each_cell(const Corners& t, Visit&& visit) const {
    constexpr double most_cells = 64;
    const Vec2 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]) / cell_;
    const Vec2 high = t[0].cwiseMax(t[1]).cwiseMax(t[2]) / cell_;
    const Vec2 extent = high - low;
    if (!((extent.x() + 1) * (extent.y() + 1) <= most_cells)) return false;
    const auto whole = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
    for (std::int64_t y = whole(low.y()); y <= whole(high.y()); ++y) {
      for (std::int64_t x = whole(low.x()); x <= whole(high.x()); ++x) visit({x, y});
    }
    return true;
  }

  double cell_;
  std::vector<Corners> all_;
  std::vector<std::size_t> large_;  // of them, those that are in no cell
  std::map<Cell, std::vector<std::size_t>> cells_;
};

/// The number of each vertex among those at different places.
std::vector<std::int32_t> welded(const std::vector<Vec3>& positions) {
  std::vector<std::int32_t> order(positions.size()), number(positions.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](std::int32_t v) {
    const Vec3& p = positions[v];
    return std::array<double, 3>{p.x(), p.y(), p.z()};
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t v, std::int32_t w) { return place(v) < place(w); });
  for (std::size_t i = 0, n = 0; i < order.size(); ++i) {
    if (i > 0 && place(order[i]) != place(order[i - 1])) ++n;
    number[order[i]] = static_cast<std::int32_t>(n);
  }
  return number;
}

/// Per halfedge 3f+i the one of another face along the same edge; −1 where not two meet.
std::vector<std::int32_t> opposites(const SurfaceMesh& mesh) {
  const std::vector<std::int32_t> number = welded(mesh.positions);
  struct Side {
    std::pair<std::int32_t, std::int32_t> ends;
    std::int32_t halfedge;
  };
  std::vector<Side> sides;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t a = number[mesh.triangles[f][i]],
                         b = number[mesh.triangles[f][(i + 1) % 3]];
      sides.push_back({std::minmax(a, b), static_cast<std::int32_t>(3 * f + i)});
    }
  }
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& s, const Side& t) { return s.ends < t.ends; });
  std::vector<std::int32_t> opposite(sides.size(), -1);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].ends == sides[i].ends) ++end;
    if (end == i + 2) {
      opposite[sides[i].halfedge] = sides[i + 1].halfedge;
      opposite[sides[i + 1].halfedge] = sides[i].halfedge;
    }
    i = end;
  }
  return opposite;
}

class ChartGrower {
 public:
  ChartGrower(const SurfaceMesh& mesh, const std::vector<char>& wanted)
      : mesh_(mesh), opposite_(opposites(mesh)), is_free_(mesh.triangles.size(), 1) {
    double sum = 0;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      const Vec3 d1 = corner(f, 1) - corner(f, 0), d2 = corner(f, 2) - corner(f, 0);
      normals_.push_back(d1.cross(d2).stableNormalized());
      const bool has_area = d1.cross(d2).squaredNorm() > 0;
      if (!has_area || (!wanted.empty() && !wanted[f])) is_free_[f] = 0;
      sum += d1.norm();
    }
    mean_edge_ = mesh.triangles.empty() ? 1 : sum / static_cast<double>(mesh.triangles.size());
    if (!(mean_edge_ > 0)) mean_edge_ = 1;
  }

  bool is_free(std::int32_t f) const { return is_free_[f]; }

  AtlasChart grow(std::int32_t seed) {
    const Vec3 axis = normals_[seed];
    const Vec3 x = (corner(seed, 1) - corner(seed, 0)).stableNormalized(), y = axis.cross(x);
    const Vec3 origin = corner(seed, 0);
    const auto lay = [&](std::int32_t f) {
      Corners flat;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 d = corner(f, i) - origin;
        flat[i] = {d.dot(x), d.dot(y)};
      }
      return flat;
    };
    AtlasChart chart;
    LaidTriangles laid(2 * mean_edge_);
    // The nearest to the axis first, so that a chart is as flat as it can be.
    using Next = std::pair<double, std::int32_t>;
    std::priority_queue<Next, std::vector<Next>, std::greater<>> front;
    front.push({0, seed});
    while (!front.empty()) {
      const std::int32_t f = front.top().second;
      front.pop();
      if (!is_free_[f]) continue;
      const Corners flat = lay(f);
      if (!(turn(flat[0], flat[1], flat[2]) > 0) || !laid.has_room_for(flat)) continue;
      is_free_[f] = 0;
      laid.add(flat);
      chart.faces.push_back(f);
      chart.corners.push_back(flat);
      for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::int32_t o = opposite_[h];
        if (o < 0 || !is_free_[o / 3]) continue;
        const double cosine = normals_[o / 3].dot(axis);
        if (cosine * most_atlas_stretch >= 1) front.push({1 - cosine, o / 3});
      }
    }
    return chart;
  }

 private:
  const Vec3& corner(std::size_t f, std::size_t i) const {
    return mesh_.positions[mesh_.triangles[f][i]];
  }

  const SurfaceMesh& mesh_;
  std::vector<std::int32_t> opposite_;
  std::vector<Vec3> normals_;
  std::vector<char> is_free_;  // in no chart yet, and to be in one
  double mean_edge_ = 1;
};

}  // namespace

std::vector<AtlasChart> atlas_charts(const SurfaceMesh& mesh, const std::vector<char>& wanted,
                                     const Context& context) {
  ChartGrower grower(mesh, wanted);
  std::vector<AtlasChart> charts;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto seed = static_cast<std::int32_t>(f);
    if (!grower.is_free(seed)) continue;
    if (charts.size() % charts_between_polls == 0) context.check();
    AtlasChart chart = grower.grow(seed);
    if (!chart.faces.empty()) charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace craze
