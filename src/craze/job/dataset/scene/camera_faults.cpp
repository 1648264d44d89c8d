#include "craze/job/dataset/scene/camera_faults.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "craze/base/elementary.h"
#include "craze/base/random.h"
#include "craze/io/image/jpeg_round_trip.h"

namespace craze {

namespace {

/// Three numbers a pixel, of 0 … 255.
struct Floats {
  int width, height;
  std::vector<float> values;

  float at(int x, int y, int c) const {
    x = std::clamp(x, 0, width - 1);
    y = std::clamp(y, 0, height - 1);
    return values[3 * (static_cast<std::size_t>(y) * width + x) + c];
  }
};

struct Tap {
  float dx, dy, weight;
};

/// Bilinear between pixels; weights sum to 1.
Floats filtered(const Floats& in, const std::vector<Tap>& taps) {
  Floats out{in.width, in.height, std::vector<float>(in.values.size(), 0.0f)};
  for (int y = 0; y < in.height; ++y) {
    for (int x = 0; x < in.width; ++x) {
      float* to = &out.values[3 * (static_cast<std::size_t>(y) * in.width + x)];
      for (const Tap& tap : taps) {
        const float fx = std::floor(tap.dx), fy = std::floor(tap.dy);
        const float u = tap.dx - fx, v = tap.dy - fy;
        const int px = x + static_cast<int>(fx), py = y + static_cast<int>(fy);
        for (int c = 0; c < 3; ++c) {
          float sum = (1 - u) * (1 - v) * in.at(px, py, c);
          if (u > 0) sum += u * (1 - v) * in.at(px + 1, py, c);
          if (v > 0) sum += (1 - u) * v * in.at(px, py + 1, c);
          if (u > 0 && v > 0) sum += u * v * in.at(px + 1, py + 1, c);
          to[c] += tap.weight * sum;
        }
      }
    }
  }
  return out;
}

void make_sum_one(std::vector<Tap>& taps) {
  float sum = 0;
  for (const Tap& t : taps) sum += t.weight;
  for (Tap& t : taps) t.weight /= sum;
}

Floats blurred(const Floats& in, double deviation) {
  if (deviation < 0.05) return in;
  const int reach = static_cast<int>(std::ceil(3 * deviation));
  std::vector<Tap> across, down;
  for (int i = -reach; i <= reach; ++i) {
    const auto w = static_cast<float>(elementary::exp(-i * i / (2 * deviation * deviation)));
    across.push_back({static_cast<float>(i), 0, w});
    down.push_back({0, static_cast<float>(i), w});
  }
  make_sum_one(across);
  make_sum_one(down);
  return filtered(filtered(in, across), down);
}

Floats shaken(const Floats& in, double length, double degrees) {
  if (length < 0.1) return in;
  const double angle = degrees * std::numbers::pi / 180;
  const double dx = length * elementary::cos(angle), dy = -length * elementary::sin(angle);
  const int steps = static_cast<int>(std::ceil(2 * length)) + 1;
  std::vector<Tap> taps;
  for (int i = 0; i < steps; ++i) {
    const double t = static_cast<double>(i) / (steps - 1) - 0.5;
    taps.push_back({static_cast<float>(t * dx), static_cast<float>(t * dy), 1});
  }
  make_sum_one(taps);
  return filtered(in, taps);
}

}  // namespace

render::Image with_camera_faults(const render::Image& image, const PlanValues& values,
                                 std::uint64_t seed) {
  Floats picture{image.width, image.height, {image.rgb.begin(), image.rgb.end()}};
  picture = blurred(picture, number_of(values, "image.blur"));
  picture =
      shaken(picture, number_of(values, "image.motion"), number_of(values, "image.motion_angle"));
  const double noise = number_of(values, "image.noise");
  const Random random(seed, 0x6e6f6973);
  render::Image out{image.width, image.height, std::vector<std::uint8_t>(image.rgb.size())};
  for (std::size_t i = 0; i < out.rgb.size(); ++i) {
    double v = picture.values[i];
    if (noise > 0) v += noise * random.normal_at(i);
    out.rgb[i] = static_cast<std::uint8_t>(std::clamp(std::floor(v + 0.5), 0.0, 255.0));
  }
  const int quality = static_cast<int>(number_of(values, "image.quality"));
  if (quality < 100) jpeg_round_trip(out.width, out.height, out.rgb, quality);
  return out;
}

}  // namespace craze
