#include "craze/mesh/shapes/organic_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/base/elementary.h"
#include "craze/mesh/shapes/revolve.h"
#include "craze/mesh/shapes/round_shapes.h"

namespace craze {

namespace {

/// Moves every point; normals follow by the inverse transpose of the map's derivative, taken by
/// central differences of `step`.
template <class Map>
void deform(SurfaceMesh& mesh, double step, const Context& context, Map&& map) {
  constexpr std::size_t slice = 1 << 14;
  for (std::size_t i = 0; i < mesh.corner_normals.size(); ++i) {
    if (i % slice == 0) context.check();
    const Vec3& p = mesh.positions[mesh.triangles[i / 3][i % 3]];
    Mat3 derivative;
    for (int k = 0; k < 3; ++k) {
      const Vec3 d = step * Vec3::Unit(k);
      derivative.col(k) = (map(Vec3(p + d)) - map(Vec3(p - d))) / (2 * step);
    }
    mesh.corner_normals[i] =
        (derivative.inverse().transpose() * mesh.corner_normals[i]).normalized();
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (v % slice == 0) context.check();
    mesh.positions[v] = map(mesh.positions[v]);
  }
}

struct Bump {
  Vec3 direction;
  double height;  // of the radius
  double width;   // radians
};

}  // namespace

SurfaceMesh make_bumps(double radius, int frequency, const Context& context) {
  const Bump bumps[] = {
      {{0.30, 0.15, 0.95}, 0.75, 0.26},    {{-0.42, 0.05, 0.90}, 0.75, 0.26},
      {{0.05, -0.95, 0.30}, 0.40, 0.42},   {{0.75, -0.45, -0.48}, 0.30, 0.32},
      {{-0.75, -0.45, -0.48}, 0.30, 0.32}, {{0.0, 0.90, -0.40}, 0.45, 0.50},
  };
  SurfaceMesh mesh = make_sphere(radius, frequency, context);
  deform(mesh, 1e-5 * radius, context, [&](const Vec3& p) -> Vec3 {
    double scale = 1;
    for (const Bump& b : bumps) {
      const Vec3 c = b.direction.normalized();
      const double angle = elementary::atan2(c.cross(p).norm(), c.dot(p)) / b.width;
      scale += b.height * elementary::exp(-angle * angle);
    }
    return scale * p;
  });
  return mesh;
}

SurfaceMesh make_drape(double radius, double height, double edge, const Context& context) {
  constexpr double deepest = 0.2;
  constexpr int folds = 9;
  const double top = 0.45 * radius, shoulder = height - top;
  const ProfileStretch base{{0, 0}, {radius, 0}};
  const ProfileStretch side =
      bezier({radius, 0}, {0.8 * radius, 0.35 * height}, {top, 0.6 * height}, {top, shoulder});
  constexpr double quarter = std::numbers::pi / 2;
  SurfaceMesh mesh = revolve({base, side, arc({0, shoulder}, top, 0, quarter)}, edge, context);
  deform(mesh, 1e-5 * radius, context, [&](const Vec3& p) -> Vec3 {
    const double down = std::clamp(1 - p.z() / shoulder, 0.0, 1.0);
    const double angle = elementary::atan2(p.y(), p.x());
    const double fold =
        elementary::cos(folds * angle + 1.3 * elementary::sin(2 * angle) + 0.8 * down);
    const double scale = 1 + deepest * down * down * (3 - 2 * down) * fold;
    return {scale * p.x(), scale * p.y(), p.z()};
  });
  return mesh;
}

}  // namespace craze
