#include "craze/job/dataset/scene/surface_look.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/base/random.h"

namespace craze {

namespace {

/// A colour of that hue, as bright as the other.
render::Rgb with_hue(const render::Rgb& color, double degrees, float saturation) {
  const double sixth = degrees / 60 - 6 * std::floor(degrees / 360);
  render::Rgb pure;
  for (int k = 0; k < 3; ++k) {
    const double away = std::abs(sixth - 2 * k);  // from red, green and blue on the wheel
    pure[k] = static_cast<float>(std::clamp(2 - std::min(away, 6 - away), 0.0, 1.0));
  }
  const render::Rgb mixed = 1 - saturation + saturation * pure;
  return render::luminance(color) / render::luminance(mixed) * mixed;
}

/// Where bricks and veins run and other clouds lie is not in the plan.
render::Pattern surface_pattern(const PlanValues& values, std::uint64_t name) {
  const auto number = [&](const char* key) { return static_cast<float>(number_of(values, key)); };
  Random random(name, 0x70617474);
  render::Pattern p;
  p.veins = number("surface.veins");
  p.vein_size = number("surface.vein_size");
  p.vein_width = number("surface.vein_width");
  p.bricks = number("surface.bricks");
  p.brick_size = number("surface.brick_size");
  p.mortar = number("surface.mortar");
  p.flaking = number("surface.flaking");
  p.flake_size = number("surface.flake_size");
  for (int k = 0; k < 3; ++k) {
    p.below[k] = number("surface.below") * static_cast<float>(random.uniform(0.75, 1.25));
  }
  p.specks = number("surface.specks");
  p.speck_size = number("surface.speck_size");
  p.angle = static_cast<float>(random.uniform(0, std::numbers::pi));
  for (int k = 0; k < 3; ++k) p.shift[k] = static_cast<float>(random.uniform(0, 4));
  return p;
}

}  // namespace

render::Material surface_material(const PlanValues& values, std::uint64_t name) {
  render::Material m = render::find_material(word_of(values, "surface.material"));
  const auto number = [&](const char* key) { return static_cast<float>(number_of(values, key)); };
  const auto set = [&](const char* key, float& field) {
    if (number(key) >= 0) field = number(key);
  };
  const float warmth = number("surface.warmth");
  const render::Rgb tint(1 + 0.25f * warmth, 1, 1 - 0.25f * warmth);
  if (number("surface.saturation") >= 0) {
    m.color = with_hue(m.color, number_of(values, "surface.hue"), number("surface.saturation"));
  }
  m.pattern = surface_pattern(values, name);
  m.color = (number("surface.brightness") * m.color * tint).min(0.95f);
  set("surface.mottle", m.mottle);
  set("surface.bump", m.bump);
  set("surface.grit", m.grit);
  set("surface.coat", m.coat);
  set("surface.gloss", m.gloss);
  m.aggregate = number("surface.aggregate");
  m.aggregate_size = number("surface.aggregate_size");
  m.line = (number("lines.brightness") * m.line).min(0.95f);
  set("lines.darkness", m.line_strength);
  m.patchiness = number("lines.patchiness");
  set("lines.stain", m.stain);
  set("lines.groove", m.groove);
  return m;
}

}  // namespace craze
