// Light from all around, photographed.
#pragma once

#include <string>
#include <vector>

#include "craze/base/image.h"
#include "craze/render/material/color.h"

namespace craze::render {

/// A picture of all directions in equal steps of longitude and latitude, its upper row straight up.
/// Directions are (right, up, ahead), unit; ahead is in the picture's middle. What shines brightest
/// in it is a lamp, so that it throws clean shadows; all else is sky.
class Environment {
 public:
  /// Linear radiance, red, green and blue or grey, of any unit: it is scaled to be as bright as the
  /// studio's own light. `name` is for messages. Throws Error(request) for a picture that is not
  /// twice as wide as high, is black, or has a number that is negative or not finite.
  explicit Environment(craze::Image image, const std::string& name = "environment");

  /// What comes from direction d, the lamp included.
  Rgb radiance(const Vec3f& d) const;
  /// The same without the lamp, coarse.
  Rgb sky(const Vec3f& d) const;

  const Vec3f& lamp_direction() const { return lamp_; }
  /// Irradiance / π on a surface that faces the lamp; zero where nothing outshines the rest.
  const Rgb& lamp_light() const { return lamp_light_; }
  /// Tangent of the half angle under which the lamp is seen.
  float lamp_size() const { return lamp_size_; }

 private:
  void find_lamp();

  craze::Image image_;
  float scale_ = 1;
  std::vector<Rgb> sky_;  // rows of cells
  Vec3f lamp_ = Vec3f::UnitY();
  Rgb lamp_light_ = Rgb::Zero();
  float lamp_size_ = 0.1f;
};

}  // namespace craze::render
