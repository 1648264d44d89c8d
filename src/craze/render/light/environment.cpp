#include "craze/render/light/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/base/elementary.h"
#include "craze/base/text/format.h"
#include "craze/error.h"

namespace craze::render {

namespace {

constexpr double pi = std::numbers::pi;
/// Cells of the sky.
constexpr int columns = 128, rows = 64;
/// Mean of radiance over all directions, that of the studio's lamp and tent.
constexpr double usual_brightness = 0.55;
/// Cosine of the angle within which what is brightest is a lamp, and of the ring around it that it
/// has to outshine.
constexpr float lamp_cosine = 0.985f, ring_cosine = 0.94f;
/// The least part of all light that a lamp gives.
constexpr double least_lamp = 0.04;

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw Error(ErrorKind::request, "cannot light a picture", name, why);
}

/// (right, up, ahead) of a place, in cells from the upper left corner.
Vec3f direction_of(double column, double row) {
  const double turn = 2 * pi * (column / columns - 0.5), fall = pi * row / rows;
  const double level = elementary::sin(fall);
  return {static_cast<float>(level * elementary::sin(turn)),
          static_cast<float>(elementary::cos(fall)),
          static_cast<float>(level * elementary::cos(turn))};
}

/// Of a cell.
double solid_angle(int row) {
  return 2 * pi / columns *
         (elementary::cos(pi * row / rows) - elementary::cos(pi * (row + 1) / rows));
}

Rgb pixel(const craze::Image& image, int x, int y) {
  const auto value = [&](int c) { return static_cast<float>(image.value(x, y, c)); };
  return image.channels < 3 ? Rgb(Rgb::Constant(value(0))) : Rgb(value(0), value(1), value(2));
}

/// Bilinear between the middles of width × height cells, around the vertical without a seam.
template <class Cell>
Rgb between(const Vec3f& d, int width, int height, Cell cell) {
  const double u = 0.5 + elementary::atan2(d.x(), d.z()) / (2 * pi);
  const double v = 0.5 - elementary::asin(std::clamp<double>(d.y(), -1, 1)) / pi;
  const double x = u * width - 0.5, y = std::clamp(v * height - 0.5, 0.0, height - 1.0);
  const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(y);
  const auto across = static_cast<float>(x - left), along = static_cast<float>(y - top);
  const auto row = [&](int r) -> Rgb {
    const int a = (left + width) % width, b = (left + 1) % width;
    return (1 - across) * cell(a, r) + across * cell(b, r);
  };
  return (1 - along) * row(top) + along * row(std::min(top + 1, height - 1));
}

}  // namespace

Environment::Environment(craze::Image image, const std::string& name) : image_(std::move(image)) {
  const int width = image_.width, height = image_.height;
  if (image_.empty() || width != 2 * height) {
    refuse(name,
           fmt::format("a picture of all directions is twice as wide as high; this one is {} × {}",
                       width, height));
  }
  // A small picture has several cells a pixel.
  sky_.assign(static_cast<std::size_t>(columns) * rows, Rgb::Zero());
  std::vector<int> count(sky_.size(), 0);
  const int steps = std::max(1, (rows + height - 1) / height);
  for (int y = 0; y < steps * height; ++y) {
    for (int x = 0; x < steps * width; ++x) {
      const Rgb c = pixel(image_, x / steps, y / steps);
      if (!c.allFinite() || c.minCoeff() < 0) refuse(name, "its light is negative or not finite");
      const std::size_t cell =
          static_cast<std::size_t>(static_cast<std::int64_t>(y) * rows / (steps * height)) *
              columns +
          static_cast<std::size_t>(static_cast<std::int64_t>(x) * columns / (steps * width));
      sky_[cell] += c;
      ++count[cell];
    }
  }
  double total = 0;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      Rgb& cell = sky_[static_cast<std::size_t>(y) * columns + x];
      cell /= static_cast<float>(std::max(1, count[static_cast<std::size_t>(y) * columns + x]));
      total += luminance(cell) * solid_angle(y);
    }
  }
  if (!(total > 0) || !std::isfinite(total)) refuse(name, "it is black");
  scale_ = static_cast<float>(usual_brightness * 4 * pi / total);
  for (Rgb& cell : sky_) cell *= scale_;
  find_lamp();
}

void Environment::find_lamp() {
  const auto brightest = std::max_element(sky_.begin(), sky_.end(), [](const Rgb& a, const Rgb& b) {
    return luminance(a) < luminance(b);
  });
  const auto index = static_cast<int>(brightest - sky_.begin());
  const Vec3f about = direction_of(index % columns + 0.5, index / columns + 0.5);
  const auto for_each_cell = [&](float from, float to, auto f) {
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        const Vec3f d = direction_of(x + 0.5, y + 0.5);
        const float c = d.dot(about);
        if (c >= from && c < to) {
          f(sky_[static_cast<std::size_t>(y) * columns + x], d, static_cast<float>(solid_angle(y)));
        }
      }
    }
  };
  Rgb ring = Rgb::Zero(), light = Rgb::Zero();
  float ring_angle = 0, weight = 0, spread = 0;
  for_each_cell(ring_cosine, lamp_cosine, [&](const Rgb& c, const Vec3f&, float angle) {
    ring += angle * c;
    ring_angle += angle;
  });
  ring /= std::max(ring_angle, 1e-6f);
  Vec3f middle = Vec3f::Zero();
  constexpr float all = 2;
  for_each_cell(lamp_cosine, all, [&](const Rgb& c, const Vec3f& d, float angle) {
    const Rgb more = angle * (c - ring).max(0.0f);
    light += more;
    middle += luminance(more) * d;
    weight += luminance(more);
  });
  if (weight < least_lamp * 4 * pi * usual_brightness) return;
  lamp_ = middle.normalized();
  lamp_light_ = light / static_cast<float>(pi);
  for_each_cell(lamp_cosine, all, [&](Rgb& c, const Vec3f& d, float angle) {
    spread += luminance(angle * (c - ring).max(0.0f)) * (d - d.dot(lamp_) * lamp_).squaredNorm();
    c = c.min(ring);
  });
  lamp_size_ = std::clamp(std::sqrt(2 * spread / weight), 0.01f, 0.2f);
}

Rgb Environment::radiance(const Vec3f& d) const {
  return scale_ *
         between(d, image_.width, image_.height, [&](int x, int y) { return pixel(image_, x, y); });
}

Rgb Environment::sky(const Vec3f& d) const {
  return between(d, columns, rows,
                 [&](int x, int y) { return sky_[static_cast<std::size_t>(y) * columns + x]; });
}

}  // namespace craze::render
