#include "craze/mesh/numbering/spatial_numbering.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace craze {

namespace {

constexpr int bits = 10;  // of the number of cells along a side of the bounding box

/// Of a cell of a grid of 2^bits cells a side, how many the Hilbert curve passes before it [J.
/// Skilling: Programming the Hilbert curve, AIP Conference Proceedings 707, 2004].
std::uint32_t along_hilbert_curve(std::array<std::uint32_t, 3> x) {
  constexpr std::uint32_t top = 1U << (bits - 1);
  for (std::uint32_t q = top; q > 1; q >>= 1) {
    for (std::uint32_t& axis : x) {
      // Turned round where the bit is set, else swapped with the first axis.
      const std::uint32_t set = (axis & q) != 0 ? q - 1 : 0;
      const std::uint32_t swapped = (x[0] ^ axis) & (q - 1) & ~set;
      axis ^= swapped;
      x[0] ^= swapped | set;
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t turned = 0;
  for (std::uint32_t q = top; q > 1; q >>= 1) turned ^= (x[2] & q) != 0 ? q - 1 : 0;
  std::uint32_t passed = 0;
  for (int bit = bits - 1; bit >= 0; --bit) {
    for (const std::uint32_t axis : x) passed = 2 * passed + (((axis ^ turned) >> bit) & 1U);
  }
  return passed;
}

/// The indices of the keys, which have 3 bits of the cell's a bit, by key, else as they come.
std::vector<std::int32_t> sorted_by(const std::vector<std::uint32_t>& keys) {
  std::vector<std::int32_t> order(keys.size()), next(keys.size());
  std::iota(order.begin(), order.end(), 0);
  constexpr std::uint32_t digits = 1U << bits;
  for (int digit = 0; digit < 3; ++digit) {
    const auto value = [&](std::int32_t i) { return keys[i] >> (digit * bits) & (digits - 1); };
    std::vector<std::size_t> first(digits + 1, 0);
    for (const std::int32_t i : order) ++first[value(i) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    for (const std::int32_t i : order) next[first[value(i)]++] = i;
    order.swap(next);
  }
  return order;
}

std::vector<std::int32_t> vertices_along_curve(const std::vector<Vec3>& positions) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : positions) box.extend(p);
  const double side = positions.empty() ? 0 : box.sizes().maxCoeff();
  const double scale = side > 0 ? ((1 << bits) - 2) / side : 0;
  // What lies on a grid must not lie where two cells meet, for rounding to decide.
  constexpr double apart = 0.618;
  std::vector<std::uint32_t> passed;
  passed.reserve(positions.size());
  for (const Vec3& p : positions) {
    const Vec3 cell = scale * (p - box.min());
    const auto along = [&](int axis) { return static_cast<std::uint32_t>(cell[axis] + apart); };
    passed.push_back(along_hilbert_curve({along(0), along(1), along(2)}));
  }
  std::vector<std::int32_t> vertices = sorted_by(passed);
  for (std::size_t i = 0, j; i < vertices.size(); i = j) {
    for (j = i + 1; j < vertices.size() && passed[vertices[j]] == passed[vertices[i]];) ++j;
    std::sort(vertices.begin() + static_cast<std::ptrdiff_t>(i),
              vertices.begin() + static_cast<std::ptrdiff_t>(j),
              [&](std::int32_t a, std::int32_t b) {
                const Vec3 &p = positions[a], &q = positions[b];
                return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
              });
  }
  return vertices;
}

/// By their corners, `now` numbered so, the lowest of each face first.
std::vector<std::int32_t> faces_by_corners(const std::vector<Triangle>& triangles,
                                           const std::vector<std::int32_t>& now) {
  const auto corners = [&](std::int32_t f) {
    const Triangle& t = triangles[f];
    Triangle sorted = {now[t[0]], now[t[1]], now[t[2]]};
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  const auto lowest = [&](const Triangle& t) {
    return std::min({now[t[0]], now[t[1]], now[t[2]]});
  };
  // Of the faces whose lowest corner is v: where they begin, and afterwards where they end.
  std::vector<std::int32_t> first(now.size() + 1, 0);
  for (const Triangle& t : triangles) ++first[lowest(t) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::int32_t> faces(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    faces[first[lowest(triangles[f])]++] = static_cast<std::int32_t>(f);
  }
  std::int32_t begin = 0;
  for (std::size_t v = 0; v < now.size(); ++v) {
    std::sort(faces.begin() + begin, faces.begin() + first[v], [&](std::int32_t a, std::int32_t b) {
      const Triangle of_a = corners(a), of_b = corners(b);
      return of_a != of_b ? of_a < of_b : a < b;
    });
    begin = first[v];
  }
  return faces;
}

}  // namespace

Numbering spatial_numbering(const std::vector<Vec3>& positions,
                            const std::vector<Triangle>& triangles) {
  Numbering numbering;
  numbering.vertices = vertices_along_curve(positions);
  numbering.faces = faces_by_corners(triangles, inverse(numbering.vertices));
  return numbering;
}

}  // namespace craze
