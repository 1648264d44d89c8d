#include "craze/render/camera.h"

#include <limits>
#include <numbers>

#include "craze/base/elementary.h"

namespace craze::render {

namespace {

constexpr double thin = 0.08;  // of the size: a plate
constexpr double sheet = 0.6;  // least length of `facing` of a sheet: a hemisphere has 0.5
constexpr double lying = 0.7;  // least part of it along the vertical of a sheet that lies

struct Axes {
  Vec3 up, right, back;  ///< back: away from the viewer at azimuth 0
  bool flat;             ///< a plate that lies
  double front;          ///< the azimuth that what stands is seen from the front at, radians
};

/// The azimuth of a level direction from the object.
double azimuth_of(const Axes& axes, const Vec3& d) {
  return elementary::atan2(d.dot(axes.right), -d.dot(axes.back));
}

Axes choose_axes(const Vec3& extent, const Vec3& facing, UpAxis up) {
  const bool automatic = up == UpAxis::automatic;
  const double size = extent.maxCoeff();
  if (automatic) up = extent.z() < thin * size ? UpAxis::z : UpAxis::y;
  const int axis = up == UpAxis::x ? 0 : up == UpAxis::y ? 1 : 2;
  Axes axes{Vec3::Unit(axis), Vec3::Unit(axis == 0 ? 1 : 0), {}, extent[axis] < thin * size, 0};
  const bool is_sheet = facing.norm() > sheet;
  const double upward = is_sheet ? facing.dot(axes.up) / facing.norm() : 0;
  if (automatic && upward < -lying) axes.up = -axes.up;
  axes.back = axes.up.cross(axes.right);
  if (axes.flat || std::abs(upward) > lying) return axes;
  if (is_sheet) {
    axes.front = azimuth_of(axes, facing);
  } else if (std::abs(extent.dot(axes.right)) < thin * size) {
    axes.front = std::numbers::pi / 2;
  }
  return axes;
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

/// Moves the eye sideways, nearer to where the points' picture is centred.
void centre_picture(const std::vector<Vec3>& points, Camera& camera) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec2 low(infinity, infinity), high(-infinity, -infinity);
  double depth = 0;
  for (const Vec3& point : points) {
    const Vec3 p = point - camera.eye;
    const double along = p.dot(camera.forward);
    const Vec2 seen = Vec2(p.dot(camera.right), p.dot(camera.up)) / along;
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
    depth += along / static_cast<double>(points.size());
  }
  const Vec2 shift = depth / 2 * (low + high);
  camera.eye += shift.x() * camera.right + shift.y() * camera.up;
}

}  // namespace

Camera frame(const Subject& subject, const View& view, double aspect) {
  const std::vector<Vec3>& points = subject.points;
  Vec3 low = points.front(), high = points.front();
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Axes axes = choose_axes(high - low, subject.facing, view.up);
  const double degree = std::numbers::pi / 180;
  const double azimuth =
      view.azimuth ? *view.azimuth * degree : axes.front + (axes.flat ? 0 : 25) * degree;

  Camera camera;
  camera.elevation = view.elevation.value_or(axes.flat ? 55 : 18);
  camera.vertical = axes.up;
  const Vec3 level = elementary::sin(azimuth) * axes.right - elementary::cos(azimuth) * axes.back;
  const double e = camera.elevation * degree;
  camera.forward = -(elementary::cos(e) * level + elementary::sin(e) * axes.up);
  camera.right = elementary::cos(azimuth) * axes.right + elementary::sin(azimuth) * axes.back;
  camera.up = camera.right.cross(camera.forward);
  camera.tan_y = elementary::tan(view.field_of_view * degree / 2);
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
  // Where there is room to spare, the middle of the sight lines is not yet the middle of the
  // picture.
  for (int pass = 0; pass < 4; ++pass) centre_picture(points, camera);
  if (view.target) {
    const Vec3 off = *view.target - camera.eye;
    camera.eye += off.dot(camera.right) * camera.right + off.dot(camera.up) * camera.up;
  }
  camera.tan_x /= view.zoom;
  camera.tan_y /= view.zoom;
  return camera;
}

}  // namespace craze::render
