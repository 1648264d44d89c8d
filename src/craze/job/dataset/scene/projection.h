// From the model to the picture's pixels, and back along rays.
#pragma once

#include "craze/render/picture.h"
#include "craze/render/rays/ray_scene.h"
#include "craze/tensor.h"

namespace craze {

/// Pixels: x to the right and y down from the picture's upper left corner; the centre of the first
/// pixel is (0.5, 0.5). Points and lengths are the model's.
class Projection {
 public:
  Projection(const render::PictureCamera& taken, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  const render::Camera& camera() const { return taken_.camera; }
  Vec3 eye() const { return taken_.centre + taken_.camera.eye / taken_.scale; }
  /// Where a point in front of the camera is seen, pixels.
  Vec2 pixel(const Vec3& p) const;
  /// How far in front of the camera it lies.
  double depth(const Vec3& p) const;
  bool in_frame(const Vec2& pixel) const;
  /// How a small step from p moves its picture, pixels: linear in the step.
  Vec2 step(const Vec3& p, const Vec3& step) const;
  /// How wide a strip of that width around a line through p is seen, across the line's picture,
  /// pixels. `along` and `across` are unit vectors in the surface.
  double seen_width(const Vec3& p, const Vec3& along, const Vec3& across, double width) const;
  /// The side of a pixel at that depth.
  double pixel_size(double depth) const;

  /// Through a place on the picture, for what is traced in render units; a hit's distance is its
  /// depth there.
  render::Ray ray(double x, double y) const;
  Vec3 to_render(const Vec3& p) const { return taken_.scale * (p - taken_.centre); }
  double scale() const { return taken_.scale; }

 private:
  render::PictureCamera taken_;
  int width_, height_;
};

}  // namespace craze
