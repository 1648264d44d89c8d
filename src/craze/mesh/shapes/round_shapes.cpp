#include "craze/mesh/shapes/round_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "craze/base/elementary.h"
#include "craze/mesh/shapes/revolve.h"

namespace craze {

namespace {

using std::numbers::pi;

// The corners of an icosahedron with one at each pole, and its sides, outward.
std::array<Vec3, 12> icosahedron_corners() {
  std::array<Vec3, 12> p;
  p[0] = {0, 0, 1};
  p[11] = {0, 0, -1};
  const double z = 1 / std::sqrt(5.0), r = 2 * z;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * pi * i / 5, b = a + pi / 5;
    p[1 + i] = {r * elementary::cos(a), r * elementary::sin(a), z};
    p[6 + i] = {r * elementary::cos(b), r * elementary::sin(b), -z};
  }
  return p;
}

std::vector<Triangle> icosahedron_sides() {
  std::vector<Triangle> sides;
  for (std::int32_t i = 0; i < 5; ++i) {
    const std::int32_t j = (i + 1) % 5;
    sides.push_back({0, 1 + i, 1 + j});
    sides.push_back({1 + i, 6 + i, 1 + j});
    sides.push_back({1 + j, 6 + i, 6 + j});
    sides.push_back({6 + i, 11, 6 + j});
  }
  return sides;
}

// Rotates the shortest way from a to b, both unit.
Vec3 along_great_circle(const Vec3& a, const Vec3& b, double t) {
  const double angle = elementary::atan2(a.cross(b).norm(), a.dot(b));
  if (angle < 1e-12) return a;
  return (elementary::sin((1 - t) * angle) * a + elementary::sin(t * angle) * b) /
         elementary::sin(angle);
}

// The point of a spherical triangle with barycentric coordinates (i, j, k)/n. The three ways of
// walking along two great circles differ a little: their mean is even, and on a side of the
// triangle it lies on that side's great circle at equal steps.
Vec3 on_sphere(const std::array<Vec3, 3>& p, const std::array<int, 3>& w) {
  Vec3 sum = Vec3::Zero();
  for (int c = 0; c < 3; ++c) {
    const int a = (c + 1) % 3, b = (c + 2) % 3, rest = w[a] + w[b], n = rest + w[c];
    if (rest == 0) return p[c];
    const double t = static_cast<double>(rest) / n;
    const Vec3 to_a = along_great_circle(p[c], p[a], t), to_b = along_great_circle(p[c], p[b], t);
    sum += along_great_circle(to_a, to_b, static_cast<double>(w[b]) / rest);
  }
  return sum.normalized();
}

// Longitude and latitude in 0 … 1. A corner on a pole takes the middle longitude of the others;
// a triangle across the date line is shifted as a whole, so its u may pass 1 before scaling.
void add_sphere_uvs(SurfaceMesh& mesh, const Triangle& t, double u_scale) {
  std::array<double, 3> u{};
  std::array<bool, 3> pole{};
  double largest = -1;
  for (int c = 0; c < 3; ++c) {
    const Vec3& n = mesh.positions[t[c]];
    pole[c] = elementary::hypot(n.x(), n.y()) < 1e-9;
    u[c] = elementary::atan2(n.y(), n.x()) / (2 * pi);
    if (u[c] < -1e-9) u[c] += 1;
    u[c] = std::max(u[c], 0.0);
    if (!pole[c]) largest = std::max(largest, u[c]);
  }
  for (int c = 0; c < 3; ++c) {
    if (largest - u[c] > 0.5) u[c] += 1;
  }
  for (int c = 0; c < 3; ++c) {
    if (pole[c]) u[c] = 0.5 * (u[(c + 1) % 3] + u[(c + 2) % 3]);
    const double z = mesh.positions[t[c]].z();
    const double latitude = elementary::asin(std::min(std::max(z, -1.0), 1.0));
    mesh.corner_uvs.emplace_back(u[c] * u_scale, latitude / pi + 0.5);
  }
}

}  // namespace

SurfaceMesh make_disc(double radius, double edge, const Context& context) {
  return revolve({{{radius, 0}, {0, 0}}}, edge, context);
}

SurfaceMesh make_sphere(double radius, int frequency, const Context& context) {
  SurfaceMesh mesh;
  const auto corners = icosahedron_corners();
  // A grid point is shared by all sides that contain it: its name lists (corner, weight), sorted.
  std::map<std::array<std::int32_t, 6>, std::int32_t> vertices;
  const auto vertex = [&](const Triangle& side, const std::array<int, 3>& w) {
    std::array<std::array<std::int32_t, 2>, 3> name{};
    for (int c = 0; c < 3; ++c) {
      name[c] = w[c] > 0 ? std::array<std::int32_t, 2>{side[c], w[c]}
                         : std::array<std::int32_t, 2>{-1, 0};
    }
    std::sort(name.begin(), name.end());
    const std::array<std::int32_t, 6> key{name[0][0], name[0][1], name[1][0],
                                          name[1][1], name[2][0], name[2][1]};
    const auto [found, added] =
        vertices.try_emplace(key, static_cast<std::int32_t>(mesh.positions.size()));
    if (added) {
      mesh.positions.push_back(
          on_sphere({corners[side[0]], corners[side[1]], corners[side[2]]}, w));
    }
    return found->second;
  };
  for (const Triangle& side : icosahedron_sides()) {
    const int n = frequency;
    const auto at = [&](int i, int j) { return vertex(side, {n - i - j, i, j}); };
    for (int i = 0; i < n; ++i) {
      context.check();
      for (int j = 0; i + j < n; ++j) {
        mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < n) mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  constexpr std::size_t slice = 1 << 16;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (f % slice == 0) context.check();
    const Triangle& t = mesh.triangles[f];
    add_sphere_uvs(mesh, t, 1);
    for (std::int32_t v : t) mesh.corner_normals.push_back(mesh.positions[v]);
  }
  double widest = 1;
  for (const Vec2& uv : mesh.corner_uvs) widest = std::max(widest, uv.x());
  for (Vec2& uv : mesh.corner_uvs) uv.x() /= widest;
  for (Vec3& p : mesh.positions) p *= radius;
  return mesh;
}

SurfaceMesh make_cylinder(double radius, double height, bool open, double edge,
                          const Context& context) {
  const double z = height / 2;
  const ProfileStretch side{{radius, -z}, {radius, z}};
  if (open) return revolve({side}, edge, context);
  return revolve({{{0, -z}, {radius, -z}}, side, {{radius, z}, {0, z}}}, edge, context);
}

SurfaceMesh make_torus(double major, double minor, double edge, const Context& context) {
  return revolve({arc({major, 0}, minor, 0, 2 * pi)}, edge, context, true);
}

SurfaceMesh make_bowl(double radius, double wall, double edge, const Context& context) {
  const double lip = wall / 2;
  const Vec2 center(0, radius);
  return revolve({arc(center, radius, -pi / 2, 0), arc({radius - lip, radius}, lip, 0, pi),
                  arc(center, radius - wall, 0, -pi / 2)},
                 edge, context);
}

SurfaceMesh make_cup(double radius, double height, double wall, double edge,
                     const Context& context) {
  const double foot = 0.07 * height, foot_out = 0.56 * radius, foot_in = foot_out - wall;
  const double lip = wall / 2, top = height - lip;
  // Outside: the underside within the foot ring, the ring, the body.
  const ProfileStretch under{{0, foot}, {foot_in, foot}};
  const ProfileStretch ring_inside{{foot_in, foot}, {foot_in, 0}};
  const ProfileStretch ring_base{{foot_in, 0}, {foot_out, 0}};
  const ProfileStretch ring_outside{{foot_out, 0}, {foot_out, foot}};
  const ProfileStretch body = bezier({foot_out, foot}, {0.97 * radius, foot + 0.02 * height},
                                     {0.95 * radius, 0.45 * height}, {radius, top});
  const ProfileStretch rim = arc({radius - lip, top}, lip, 0, pi);
  // Inside: down the wall and round to the middle of the bottom.
  const double bottom = foot + wall;
  const ProfileStretch inside = bezier({radius - wall, top}, {0.95 * radius - wall, 0.45 * height},
                                       {0.9 * radius - wall, bottom}, {0, bottom});
  return revolve({under, ring_inside, ring_base, ring_outside, body, rim, inside}, edge, context);
}

}  // namespace craze
