#include <algorithm>
#include <cmath>
#include <vector>

#include "craze/base/elementary.h"
#include "craze/base/random.h"
#include "craze/products/statistics/graph/clipped_network.h"
#include "craze/products/statistics/null_models/null_networks.h"

namespace craze {
namespace {

constexpr double margin = 4;  // a cell of the window has no neighbour farther out

/// A corner of a cell, and the site across the side that leaves it; −1: none, the outer box.
struct CellCorner {
  Vec2 p;
  std::int32_t across;
};

/// Keeps the side of the bisector of p and q that holds p.
void clip(std::vector<CellCorner>& cell, const Vec2& p, const Vec2& q, std::int32_t across) {
  const Vec2 normal = q - p, middle = (p + q) / 2;
  const auto outside = [&](const CellCorner& c) { return normal.dot(c.p - middle); };
  std::vector<CellCorner> kept;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const CellCorner& a = cell[i];
    const CellCorner& b = cell[(i + 1) % cell.size()];
    const double da = outside(a), db = outside(b);
    if (da <= 0) kept.push_back(a);
    if ((da <= 0) == (db <= 0)) continue;
    const Vec2 cut = a.p + da / (da - db) * (b.p - a.p);
    kept.push_back({cut, da <= 0 ? across : a.across});
  }
  cell = std::move(kept);
}

/// Sites in unit squares.
class Sites {
 public:
  Sites(double side, Random& random)
      : width_(static_cast<std::int32_t>(std::ceil(side + 2 * margin))) {
    buckets_.resize(static_cast<std::size_t>(width_) * width_);
    for (std::vector<std::int32_t>& bucket : buckets_) {
      const auto index = static_cast<std::int32_t>(&bucket - buckets_.data());
      // Poisson with mean 1 (Knuth): as many uniform factors as stay above e⁻¹.
      for (double product = random.uniform(); product > elementary::exp(-1.0);
           product *= random.uniform()) {
        bucket.push_back(static_cast<std::int32_t>(points_.size()));
        const std::int32_t column = index % width_, row = index / width_;
        const double x = column + random.uniform();
        points_.emplace_back(x - margin, row + random.uniform() - margin);
      }
    }
  }

  const std::vector<Vec2>& points() const { return points_; }

  std::vector<CellCorner> cell(std::int32_t i) const {
    const Vec2 p = points_[i];
    const double low = -margin, high = width_ - margin;
    std::vector<CellCorner> cell{
        {{low, low}, -1}, {{high, low}, -1}, {{high, high}, -1}, {{low, high}, -1}};
    const auto x = static_cast<std::int32_t>(p.x() + margin);
    const auto y = static_cast<std::int32_t>(p.y() + margin);
    // Rings of squares outwards; ring r is at least r − 1 away, and only sites closer than twice
    // the farthest corner cut the cell.
    for (std::int32_t r = 0; r <= width_; ++r) {
      double reach = 0;
      for (const CellCorner& c : cell) reach = std::max(reach, (c.p - p).norm());
      if (r - 1 > 2 * reach) break;
      for (std::int32_t v = y - r; v <= y + r; ++v) {
        const std::int32_t step = v == y - r || v == y + r ? 1 : std::max(1, 2 * r);
        for (std::int32_t u = x - r; u <= x + r; u += step) {
          if (u < 0 || v < 0 || u >= width_ || v >= width_) continue;
          for (const std::int32_t j : buckets_[static_cast<std::size_t>(v) * width_ + u]) {
            if (j != i) clip(cell, p, points_[j], j);
          }
        }
      }
    }
    return cell;
  }

 private:
  std::int32_t width_;
  std::vector<Vec2> points_;
  std::vector<std::vector<std::int32_t>> buckets_;
};

}  // namespace

CrackNetwork voronoi_network(double side, std::uint64_t seed) {
  Random random(seed, 0x766f726f);  // "voro"
  const Sites sites(side, random);
  ClippedNetwork network(side);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(sites.points().size()); ++i) {
    const std::vector<CellCorner> cell = sites.cell(i);
    const std::size_t n = cell.size();
    // A corner is named by the three sites around it.
    const auto key = [&](std::size_t k) {
      ClippedNetwork::Key sites_around{i, cell[(k + n - 1) % n].across, cell[k % n].across};
      std::sort(sites_around.begin(), sites_around.end());
      return sites_around;
    };
    for (std::size_t k = 0; k < n; ++k) {
      if (cell[k].across < i) continue;  // met from the other side, or the outer box
      network.add(key(k), cell[k].p, key(k + 1), cell[(k + 1) % n].p);
    }
  }
  return network.take();
}

}  // namespace craze
