#include "craze/mesh/crossing/triangles_cross.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "craze/base/random.h"

namespace craze {
namespace {

constexpr double rounding = 1e-9;

double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// The definition, pair of edge and triangle by pair, without a shortcut.
class Plain {
 public:
  explicit Plain(const std::vector<Vec3>& positions) : p_(positions) {}

  bool cross(const Triangle& s, const Triangle& t, bool one_sheet) const {
    int common = 0, of_s = -1, of_t = -1;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (at(s, i) != at(t, j)) continue;
        ++common;
        of_s = i;
        of_t = j;
      }
    }
    if (common >= 2) return false;
    Eigen::AlignedBox3d both;
    for (int i = 0; i < 3; ++i) both.extend(at(s, i)).extend(at(t, i));
    const double size = both.diagonal().norm();
    return pierces(s, of_s, t, of_t, size) || pierces(t, of_t, s, of_s, size) ||
           (one_sheet && overlap(s, t, size));
  }

 private:
  const Vec3& at(const Triangle& t, int i) const { return p_[t[static_cast<std::size_t>(i % 3)]]; }
  Vec3 normal(const Triangle& t) const { return (at(t, 1) - at(t, 0)).cross(at(t, 2) - at(t, 0)); }

  bool pierces(const Triangle& s, int of_s, const Triangle& t, int of_t, double size) const {
    const double tiny = rounding * size * size * size, by_ab = of_t >= 0 ? -tiny : tiny;
    const int k = std::max(of_t, 0) + 1;
    const Vec3 &a = at(t, k), &b = at(t, k + 1), &c = at(t, k + 2);
    for (int i = 0; i < 3; ++i) {
      if (i == of_s || (i + 1) % 3 == of_s) continue;
      const Vec3 &p = at(s, i), &q = at(s, i + 1);
      for (const double sign : {1.0, -1.0}) {
        if (sign * volume(a, b, c, p) > tiny && sign * volume(a, b, c, q) < -tiny &&
            -sign * volume(p, q, a, b) > by_ab && -sign * volume(p, q, b, c) > tiny &&
            -sign * volume(p, q, c, a) > tiny) {
          return true;
        }
      }
    }
    return false;
  }

  bool overlap(const Triangle& s, const Triangle& t, double size) const {
    const bool s_is_larger = normal(s).squaredNorm() > normal(t).squaredNorm();
    const Triangle &large = s_is_larger ? s : t, &small = s_is_larger ? t : s;
    const Vec3 n = normal(large).stableNormalized();
    if (!(normal(s).dot(normal(t)) > 0)) return false;
    for (int i = 0; i < 3; ++i) {
      if (std::abs(n.dot(at(small, i) - at(large, 0))) > rounding * size) return false;
    }
    return !parts(s, t, n, size) && !parts(t, s, n, size);
  }

  bool parts(const Triangle& s, const Triangle& t, const Vec3& n, double size) const {
    for (int i = 0; i < 3; ++i) {
      const Vec3 outwards = (at(s, i + 1) - at(s, i)).cross(n).stableNormalized();
      double least = INFINITY;
      for (int j = 0; j < 3; ++j) least = std::min(least, outwards.dot(at(t, j) - at(s, i)));
      if (least >= -rounding * size) return true;
    }
    return false;
  }

  const std::vector<Vec3>& p_;
};

/// Two triangles, often nearly in one plane, slivers, or touching at edges and corners by less or
/// more than rounding.
std::vector<Vec3> hard_corners(Random& random) {
  const auto normal = [&] { return Vec3(random.normal(), random.normal(), random.normal()); };
  const auto often = [&](double part) { return random.uniform() < part; };
  const auto small = [&] { return std::pow(10, -15 * random.uniform()); };
  const double flat = often(0.4) ? 0 : small();
  const Vec3 origin = often(0.3) ? Vec3(100 * normal()) : Vec3::Zero();
  const bool on_grid = often(0.3);
  std::vector<Vec3> p;
  for (int i = 0; i < 6; ++i) {
    Vec3 at = normal();
    if (on_grid) at = (2 * at).array().round() / 2;
    at.z() = flat * random.normal();
    p.push_back(origin + at);
  }
  const auto onto_edge = [&](int of, int a, int b) {
    p[of] = p[a] + random.uniform() * (p[b] - p[a]) + small() * normal();
  };
  if (often(0.2)) onto_edge(2, 0, 1);
  if (often(0.2)) onto_edge(5, 3, 4);
  if (often(0.3)) onto_edge(4, 1, 2);
  if (often(0.1)) p[5] = p[2] + small() * normal();
  return p;
}

TEST(TrianglesCross, AQuickLookChangesNothing) {
  Random random(8);
  int crossings[2] = {};
  for (int n = 0; n < 200000; ++n) {
    std::vector<Vec3> p = hard_corners(random);
    const auto corner = [&] { return static_cast<std::int32_t>(3 * random.uniform()); };
    const Triangle s{0, 1, 2};
    Triangle t{3, 4, 5};
    if (const double kind = random.uniform(); kind < 0.5) {
      t[static_cast<std::size_t>(corner())] = corner();
    } else if (kind < 0.65) {
      p[3 + corner()] = p[corner()];
    }
    if (random.uniform() < 0.5) std::swap(t[1], t[2]);
    for (const bool one_sheet : {false, true}) {
      const bool expected = Plain(p).cross(s, t, one_sheet);
      ASSERT_EQ(triangles_cross(p, s, t, one_sheet), expected) << n;
      crossings[one_sheet ? 1 : 0] += expected ? 1 : 0;
    }
  }
  EXPECT_GT(crossings[0], 5000);
  EXPECT_GT(crossings[1], crossings[0] + 5000);
}

}  // namespace
}  // namespace craze
