#include "craze/job/dataset/scene/projection.h"

#include <cmath>

namespace craze {

Projection::Projection(const render::PictureCamera& taken, int width, int height)
    : taken_(taken), width_(width), height_(height) {}

Vec2 Projection::pixel(const Vec3& p) const {
  const render::Camera& c = taken_.camera;
  const Vec3 q = to_render(p) - c.eye;
  const double z = q.dot(c.forward);
  return {width_ * (q.dot(c.right) / (z * c.tan_x) + 1) / 2,
          height_ * (1 - q.dot(c.up) / (z * c.tan_y)) / 2};
}

double Projection::depth(const Vec3& p) const {
  return (to_render(p) - taken_.camera.eye).dot(taken_.camera.forward) / taken_.scale;
}

bool Projection::in_frame(const Vec2& p) const {
  return p.x() >= 0 && p.y() >= 0 && p.x() <= width_ && p.y() <= height_;
}

Vec2 Projection::step(const Vec3& p, const Vec3& step) const {
  const render::Camera& c = taken_.camera;
  const Vec3 q = to_render(p) - c.eye, d = taken_.scale * step;
  const double z = q.dot(c.forward), dz = d.dot(c.forward);
  const double x = (d.dot(c.right) * z - q.dot(c.right) * dz) / (z * z);
  const double y = (d.dot(c.up) * z - q.dot(c.up) * dz) / (z * z);
  return {width_ * x / (2 * c.tan_x), -height_ * y / (2 * c.tan_y)};
}

double Projection::seen_width(const Vec3& p, const Vec3& along, const Vec3& across,
                              double width) const {
  const Vec2 a = step(p, along), b = step(p, across);
  const double length = a.norm();
  return length > 0 ? width * std::abs(a.x() * b.y() - a.y() * b.x()) / length : 0;
}

double Projection::pixel_size(double depth) const {
  return depth * 2 * taken_.camera.tan_y / height_;
}

render::Ray Projection::ray(double x, double y) const {
  const Vec3 direction = taken_.camera.ray(2 * x / width_ - 1, 1 - 2 * y / height_);
  return {taken_.camera.eye.cast<float>(), direction.cast<float>(), 0, true};
}

}  // namespace craze
