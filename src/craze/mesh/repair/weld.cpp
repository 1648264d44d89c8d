#include "craze/mesh/repair/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "craze/base/random.h"

namespace craze {

namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& c) const {
    std::uint64_t h = 0;
    for (std::int64_t x : c) h = hash_bits(h ^ static_cast<std::uint64_t>(x));
    return static_cast<std::size_t>(h);
  }
};

bool before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

std::vector<std::int32_t> weld_equal(const std::vector<Vec3>& positions) {
  std::vector<std::int32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return before(positions[a], positions[b]);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool equal = i > 0 && positions[order[i]] == positions[order[i - 1]];
    first[order[i]] = equal ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace

std::vector<std::int32_t> weld(const std::vector<Vec3>& positions, double tolerance) {
  if (tolerance <= 0) return weld_equal(positions);
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  for (const Vec3& p : positions) low = low.cwiseMin(p);

  // Cells several tolerances wide: most points then need to look into one cell only.
  const double width = 8 * tolerance;
  std::unordered_map<Cell, std::int32_t, CellHash> newest;  // of the representatives in a cell
  std::vector<std::int32_t> older(positions.size(), -1);    // the next one in the same cell
  newest.reserve(positions.size());
  std::vector<std::int32_t> first(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vec3 at = (positions[v] - low) / width, reach = Vec3::Constant(tolerance / width);
    const Vec3 from = (at - reach).array().floor(), to = (at + reach).array().floor();
    std::int32_t found = static_cast<std::int32_t>(v);
    for (double x = from.x(); x <= to.x(); ++x) {
      for (double y = from.y(); y <= to.y(); ++y) {
        for (double z = from.z(); z <= to.z(); ++z) {
          const auto cell =
              newest.find(Cell{static_cast<std::int64_t>(x), static_cast<std::int64_t>(y),
                               static_cast<std::int64_t>(z)});
          if (cell == newest.end()) continue;
          for (std::int32_t r = cell->second; r >= 0; r = older[r]) {
            if ((positions[r] - positions[v]).norm() <= tolerance) found = std::min(found, r);
          }
        }
      }
    }
    first[v] = found;
    if (found != static_cast<std::int32_t>(v)) continue;
    const Vec3 own = at.array().floor();
    const auto [slot, added] = newest.try_emplace(
        Cell{static_cast<std::int64_t>(own.x()), static_cast<std::int64_t>(own.y()),
             static_cast<std::int64_t>(own.z())},
        found);
    if (!added) {
      older[v] = slot->second;
      slot->second = found;
    }
  }
  return first;
}

}  // namespace craze
