#include "craze/render/material/pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/base/elementary.h"
#include "craze/render/material/noise.h"

namespace craze::render {

namespace {

/// Turned about z, so that courses run any way on what lies flat.
Vec3f turned(const Vec3f& p, float angle) {
  const auto c = static_cast<float>(elementary::cos(angle));
  const auto s = static_cast<float>(elementary::sin(angle));
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()};
}

/// The value that a share of the noise exceeds: its values are spread as a bell is, whose quantiles
/// Tukey's lambda distribution has nearly (standard deviation 0.242, measured).
float level_above(float share) {
  constexpr double lambda = 0.135, unit = 0.1975;
  const double s = static_cast<double>(share);
  return static_cast<float>(0.242 / unit *
                            (elementary::pow(1 - s, lambda) - elementary::pow(s, lambda)));
}

/// Dark bands that wander: 1 in the middle of one.
float vein_at(const Pattern& pattern, const Vec3f& place, float footprint) {
  const float bent = 0.8f * fractal_noise(0.3f / pattern.vein_size * place).value +
                     0.06f * fractal_noise(4 / pattern.vein_size * place, 2).value;
  const float row = place.y() / pattern.vein_size + 2 * bent;
  const float from_middle = std::abs(row - std::floor(row) - 0.5f);  // of the way to the next
  const float half = 0.5f * pattern.vein_width;
  const float soft = std::max(0.6f * half, footprint / pattern.vein_size);
  // Veins come and go along their way.
  const float part = smoothstep(-0.5f, 0.3f, value_noise(0.35f / pattern.vein_size * place).value);
  return part * (1 - smoothstep(half - soft, half + soft, from_middle));
}

struct Joint {
  float inside = 0;  ///< 0 … 1, how much of the place is mortar
  Vec3f lean = Vec3f::Zero();
};

/// The mortar of bricks laid in half bond in the plane of x and y.
Joint joint_at(const Pattern& pattern, const Vec3f& place, float footprint) {
  const float y = place.y() / pattern.brick_size, course = std::floor(y);
  const float odd = course - 2 * std::floor(course / 2);
  const float x = place.x() / (2 * pattern.brick_size) + 0.5f * odd;
  const float off_y = y - course - 0.5f, off_x = 2 * (x - std::floor(x) - 0.5f);
  const float to_bed = 0.5f - std::abs(off_y), to_head = 1 - std::abs(off_x);
  const bool bed = to_bed < to_head;
  const float half = 0.5f * pattern.mortar;
  const float soft = std::max(0.25f * half, footprint / pattern.brick_size);
  Joint joint;
  joint.inside = 1 - smoothstep(half - soft, half + soft, std::min(to_bed, to_head));
  const float slope = 4 * joint.inside * (1 - joint.inside);
  joint.lean =
      bed ? Vec3f(0, off_y > 0 ? slope : -slope, 0) : Vec3f(off_x > 0 ? slope : -slope, 0, 0);
  return joint;
}

}  // namespace

PatternSample pattern_at(const Pattern& pattern, const Vec3f& place, float footprint) {
  PatternSample sample;
  const Vec3f at = place + pattern.shift;
  if (pattern.specks > 0) {
    const Random speck(nearest_cell(at / pattern.speck_size).id);
    const auto shade = static_cast<float>(speck.uniform_at(3) - 0.5);
    for (int k = 0; k < 3; ++k) {
      const auto own = static_cast<float>(speck.uniform_at(k + 4) - 0.5);
      sample.tint[k] *= std::max(0.1f, 1 + pattern.specks * (0.9f * shade + 0.5f * own));
    }
  }
  if (pattern.flaking > 0) {
    const Noise patch = fractal_noise(at / pattern.flake_size, 5);
    const float level = level_above(pattern.flaking);
    const float slope = std::max(1.0f, patch.gradient.norm());
    const float soft = slope * footprint / pattern.flake_size;
    const float gone = smoothstep(level - soft, level + soft, patch.value);
    sample.tint *= 1 + gone * (pattern.below - 1);
    const float edge = 1 - smoothstep(0.5f * soft, 2.5f * soft, std::abs(patch.value - level));
    sample.tilt += 0.35f * edge / slope * patch.gradient;
  }
  const Vec3f along = turned(at, pattern.angle);
  if (pattern.veins > 0) sample.tint *= 1 - pattern.veins * vein_at(pattern, along, footprint);
  if (pattern.bricks != 0) {
    const Joint joint = joint_at(pattern, along, footprint);
    sample.tint *= 1 - pattern.bricks * joint.inside;
    sample.tilt += 0.4f * turned(joint.lean, -pattern.angle);
  }
  return sample;
}

}  // namespace craze::render
