#include "craze/mesh/smooth_normals.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <tuple>

#include "craze/base/elementary.h"

namespace craze {

namespace {

Vec3 unit_or_zero(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

/// Vertices by group of equal position.
std::vector<std::int32_t> weld(const std::vector<Vec3>& positions) {
  const auto key = [&](std::int32_t v) {
    return std::make_tuple(positions[v].x(), positions[v].y(), positions[v].z());
  };
  std::vector<std::int32_t> order(positions.size()), group(positions.size(), 0);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < order.size(); ++i) {
    group[order[i]] = group[order[i - 1]] + (key(order[i]) != key(order[i - 1]) ? 1 : 0);
  }
  return group;
}

/// Which corners are shaded as one: a forest over the corners.
class Joined {
 public:
  explicit Joined(std::size_t corners) : parent_(corners) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::int32_t root(std::int32_t c) {
    while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
    return c;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::int32_t> parent_;
};

/// The corners around each place: those of place g are corners[first[g]] … corners[first[g + 1]].
struct CornersByPlace {
  std::vector<std::int32_t> first, corners;

  explicit CornersByPlace(const SurfaceMesh& mesh)
      : first(mesh.positions.size() + 1, 0), corners(3 * mesh.triangles.size()) {
    const std::vector<std::int32_t> group = weld(mesh.positions);
    const auto group_of = [&](std::size_t c) { return group[mesh.triangles[c / 3][c % 3]]; };
    for (std::size_t c = 0; c < corners.size(); ++c) ++first[group_of(c) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int32_t> fill(first.begin(), first.end() - 1);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      corners[fill[group_of(c)]++] = static_cast<std::int32_t>(c);
    }
  }
};

}  // namespace

std::vector<Vec3> smooth_normals(const SurfaceMesh& mesh, double crease) {
  const std::size_t corners = 3 * mesh.triangles.size();
  std::vector<Vec3> face_normal(mesh.triangles.size()), sum(corners, Vec3::Zero());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    face_normal[f] = unit_or_zero((b - a).cross(c - a));
  }

  Joined joined(corners);
  const CornersByPlace places(mesh);
  const double limit = elementary::cos(crease * std::numbers::pi / 180);
  for (std::size_t g = 0; g + 1 < places.first.size(); ++g) {
    for (std::int32_t i = places.first[g]; i < places.first[g + 1]; ++i) {
      for (std::int32_t j = i + 1; j < places.first[g + 1]; ++j) {
        const std::int32_t a = places.corners[i], b = places.corners[j];
        if (face_normal[a / 3].dot(face_normal[b / 3]) >= limit) joined.join(a, b);
      }
    }
  }

  for (std::size_t c = 0; c < corners; ++c) {
    const Triangle& t = mesh.triangles[c / 3];
    const std::size_t i = c % 3;
    const Vec3 &p = mesh.positions[t[i]], &q = mesh.positions[t[(i + 1) % 3]],
               &r = mesh.positions[t[(i + 2) % 3]];
    const double angle = elementary::atan2((q - p).cross(r - p).norm(), (q - p).dot(r - p));
    sum[joined.root(static_cast<std::int32_t>(c))] += angle * face_normal[c / 3];
  }
  std::vector<Vec3> normals(corners);
  for (std::size_t c = 0; c < corners; ++c) {
    normals[c] = unit_or_zero(sum[joined.root(static_cast<std::int32_t>(c))]);
  }
  return normals;
}

}  // namespace craze
