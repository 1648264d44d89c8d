#include "craze/render/camera.h"

#include <limits>
#include <numbers>

namespace craze::render {

namespace {

struct Axes {
  Vec3 up, right;
  bool flat;
};

Axes choose_axes(const Vec3& extent, UpAxis up) {
  constexpr double thin = 0.08;
  const double size = extent.maxCoeff();
  if (up == UpAxis::automatic) up = extent.z() < thin * size ? UpAxis::z : UpAxis::y;
  const int axis = up == UpAxis::x ? 0 : up == UpAxis::y ? 1 : 2;
  return {Vec3::Unit(axis), Vec3::Unit(axis == 0 ? 1 : 0), extent[axis] < thin * size};
}

/// The bounds of the points' sight lines to one side: the eye must lie between them.
struct Support {
  double positive = -std::numeric_limits<double>::infinity();
  double negative = -std::numeric_limits<double>::infinity();

  void add(double across, double along, double tangent) {
    positive = std::max(positive, across - tangent * along);
    negative = std::max(negative, -across - tangent * along);
  }
  double centre() const { return (positive - negative) / 2; }
  double along(double tangent) const { return -(positive + negative) / (2 * tangent); }
};

}  // namespace

Camera frame(const std::vector<Vec3>& points, const View& view, double aspect) {
  Vec3 low = points.front(), high = points.front();
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Axes axes = choose_axes(high - low, view.up);
  const double degree = std::numbers::pi / 180;
  const double azimuth = view.azimuth.value_or(axes.flat ? 0 : 25) * degree;

  Camera camera;
  camera.elevation = view.elevation.value_or(axes.flat ? 55 : 18);
  camera.vertical = axes.up;
  const Vec3 back = axes.up.cross(axes.right);  // away from the viewer at azimuth 0
  const Vec3 level = std::sin(azimuth) * axes.right - std::cos(azimuth) * back;
  const double e = camera.elevation * degree;
  camera.forward = -(std::cos(e) * level + std::sin(e) * axes.up);
  camera.right = std::cos(azimuth) * axes.right + std::sin(azimuth) * back;
  camera.up = camera.right.cross(camera.forward);
  camera.tan_y = std::tan(view.field_of_view * degree / 2);
  camera.tan_x = camera.tan_y * aspect;

  const double tx = camera.tan_x * (1 - 2 * view.margin), ty = camera.tan_y * (1 - 2 * view.margin);
  Support x, y;
  for (const Vec3& p : points) {
    x.add(p.dot(camera.right), p.dot(camera.forward), tx);
    y.add(p.dot(camera.up), p.dot(camera.forward), ty);
  }
  // A single point needs some distance too.
  const double along = std::min(x.along(tx), y.along(ty)) - 1e-6 * (1 + (high - low).norm());
  camera.eye = x.centre() * camera.right + y.centre() * camera.up + along * camera.forward;
  return camera;
}

}  // namespace craze::render
