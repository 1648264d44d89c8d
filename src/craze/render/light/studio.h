// The light a picture is taken in: one large lamp, a bright tent around it, a grey backdrop; or a
// photographed environment's lamp and sky.
#pragma once

#include <memory>
#include <optional>

#include "craze/render/camera.h"
#include "craze/render/light/environment.h"
#include "craze/render/material/color.h"

namespace craze::render {

/// Where the lamp stands, degrees: to the right of the camera, 180 behind the object; and above the
/// horizon. By default to the left of the camera, and behind the object when seen from above, so
/// that relief always shows.
struct LampPlace {
  std::optional<double> azimuth, elevation;
};

/// Null: the studio's own light. The picture's middle is straight ahead of the camera, turned by so
/// many degrees to the right.
struct EnvironmentPlace {
  std::shared_ptr<const Environment> environment;
  double turn = 0;
};

class Studio {
 public:
  Studio(const Camera& camera, const Rgb& backdrop, const LampPlace& lamp = {},
         const EnvironmentPlace& around = {});

  const Vec3f& vertical() const { return vertical_; }
  const Vec3f& lamp_direction() const { return lamp_; }
  /// Tangent of the half angle under which the lamp is seen: the softness of shadows.
  float lamp_size() const { return lamp_size_; }
  /// Irradiance / π on a surface that faces the unshadowed lamp.
  const Rgb& lamp_light() const { return lamp_light_; }

  /// Radiance of the tent, without the lamp, from direction d (unit).
  Rgb sky(const Vec3f& d) const;
  /// What a mirror sees in direction d (unit): the tent, a tall window on the lamp's side and a
  /// strip light.
  Rgb reflection(const Vec3f& d) const;
  /// The backdrop at a place on the picture, x and y in −1 … 1.
  Rgb backdrop(float x, float y) const;
  /// Where on the picture a direction points to; past the rim for what lies behind the camera.
  void project(const Vec3f& d, float& x, float& y) const;

 private:
  void place_lamp(const Camera& camera, const Vec3& back, const LampPlace& lamp);
  float screen(const Vec3f& d, const Vec3f& centre, const Vec3f& upright, float half_width,
               float half_height) const;

  void light_by(const Camera& camera, const Vec3& back, const EnvironmentPlace& around);
  Vec3f in_environment(const Vec3f& d) const;

  Vec3f vertical_, right_, up_, forward_, lamp_, window_, strip_;
  float tan_x_, tan_y_, lamp_size_ = 0.16f;
  Rgb lamp_light_, backdrop_;
  std::shared_ptr<const Environment> environment_;
  Eigen::Matrix3f to_environment_;
};

}  // namespace craze::render
