#include "craze/render/light/studio.h"

#include <cmath>
#include <numbers>

#include "craze/base/elementary.h"

namespace craze::render {

namespace {

Vec3f direction(const Vec3& d) {
  return d.normalized().cast<float>();
}

}  // namespace

Studio::Studio(const Camera& camera, const Rgb& backdrop, const LampPlace& lamp,
               const EnvironmentPlace& around)
    : vertical_(direction(camera.vertical)),
      right_(direction(camera.right)),
      up_(direction(camera.up)),
      forward_(direction(camera.forward)),
      tan_x_(static_cast<float>(camera.tan_x)),
      tan_y_(static_cast<float>(camera.tan_y)),
      lamp_light_(1.14f, 1.09f, 1.02f),
      backdrop_(backdrop) {
  const Vec3 back = camera.vertical.cross(camera.right);  // level, away from the viewer
  const double above = smoothstep(25, 75, static_cast<float>(camera.elevation));
  lamp_ = direction(-0.75 * camera.right + 0.95 * camera.vertical + (1.3 * above - 0.7) * back);
  window_ = direction(-0.8 * camera.right + (0.12 + 0.5 * above) * camera.vertical +
                      (1.2 * above - 0.62) * back);
  if (around.environment) light_by(camera, back, around);
  if (lamp.azimuth || lamp.elevation) place_lamp(camera, back, lamp);
  strip_ = direction(0.95 * camera.right + 0.45 * camera.vertical + 0.1 * back);
}

void Studio::place_lamp(const Camera& camera, const Vec3& back, const LampPlace& lamp) {
  constexpr double degree = std::numbers::pi / 180;
  const Vec3 usual = lamp_.cast<double>();
  const double azimuth =
      lamp.azimuth.value_or(elementary::atan2(usual.dot(camera.right), -usual.dot(back)) / degree) *
      degree;
  const double elevation =
      lamp.elevation.value_or(elementary::asin(usual.dot(camera.vertical)) / degree) * degree;
  const Vec3 level = elementary::sin(azimuth) * camera.right - elementary::cos(azimuth) * back;
  lamp_ =
      direction(elementary::cos(elevation) * level + elementary::sin(elevation) * camera.vertical);
  // The window that shines in reflections is on the same side.
  window_ = direction(level + elementary::sin(elevation) * camera.vertical);
}

void Studio::light_by(const Camera& camera, const Vec3& back, const EnvironmentPlace& around) {
  environment_ = around.environment;
  const double turn = around.turn * std::numbers::pi / 180;
  const double c = elementary::cos(turn), s = elementary::sin(turn);
  to_environment_.row(0) = direction(c * camera.right - s * back);
  to_environment_.row(1) = direction(camera.vertical);
  to_environment_.row(2) = direction(c * back + s * camera.right);
  lamp_light_ = environment_->lamp_light();
  lamp_size_ = environment_->lamp_size();
  lamp_ = to_environment_.transpose() * environment_->lamp_direction();
}

Vec3f Studio::in_environment(const Vec3f& d) const {
  return to_environment_ * d;
}

Rgb Studio::sky(const Vec3f& d) const {
  if (environment_) return environment_->sky(in_environment(d));
  const float height = d.dot(vertical_);
  if (height < 0) return {0.20f, 0.19f, 0.18f};  // light from the floor
  const Rgb zenith(0.42f, 0.44f, 0.48f), horizon(0.26f, 0.27f, 0.29f);
  const float side = 0.5f + 0.5f * d.dot(lamp_);
  return (horizon + height * (zenith - horizon)) * (0.55f + 0.75f * side * side);
}

float Studio::screen(const Vec3f& d, const Vec3f& centre, const Vec3f& upright, float half_width,
                     float half_height) const {
  const float ahead = d.dot(centre);
  if (ahead <= 0.05f) return 0;
  const Vec3f across = upright.cross(centre).normalized(), along = centre.cross(across);
  const float x = std::abs(d.dot(across) / ahead), y = std::abs(d.dot(along) / ahead);
  const float edge = 0.06f;
  return (1 - smoothstep(half_width - edge, half_width + edge, x)) *
         (1 - smoothstep(half_height - edge, half_height + edge, y));
}

Rgb Studio::reflection(const Vec3f& d) const {
  // A brighter one would be a spark in the pixel of a single ray that meets it.
  constexpr float most = 12;
  if (environment_) return environment_->radiance(in_environment(d)).min(most);
  const float window = screen(d, window_, vertical_, 0.21f, 0.62f);
  const float strip = screen(d, strip_, vertical_, 0.09f, 0.75f);
  return 0.9f * sky(d) + 5.0f * window * lamp_light_ + 1.6f * strip * Rgb(0.92f, 0.96f, 1.0f);
}

Rgb Studio::backdrop(float x, float y) const {
  const float dx = x + 0.12f, dy = 0.85f * (y + 0.05f);
  const float r = dx * dx + dy * dy;
  return backdrop_ * (1.12f - 0.42f * smoothstep(0.05f, 1.9f, r));
}

void Studio::project(const Vec3f& d, float& x, float& y) const {
  const float ahead = std::max(d.dot(forward_), 0.05f);
  x = std::clamp(d.dot(right_) / (ahead * tan_x_), -1.5f, 1.5f);
  y = std::clamp(d.dot(up_) / (ahead * tan_y_), -1.5f, 1.5f);
}

}  // namespace craze::render
