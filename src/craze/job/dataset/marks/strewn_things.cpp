#include "craze/job/dataset/marks/strewn_things.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "craze/base/elementary.h"

namespace craze {

namespace {

using render::Mark;
using render::MarkShape;
using render::Rgb;

float part(Random& random, double low, double high) {
  return static_cast<float>(random.uniform(low, high));
}

/// From dark to light, more or less brown.
Rgb thing_color(Random& random) {
  const float light = part(random, 0.02, 0.7), warm = part(random, -0.1, 0.5);
  return {light, light * (1 - 0.4f * warm), light * (1 - 0.8f * warm)};
}

/// The direction in the surface at an angle to the place's.
Vec3 turned(const Mark& at, double angle) {
  return elementary::cos(angle) * at.along + elementary::sin(angle) * at.normal.cross(at.along);
}

/// A thread of a length and width in pixels, bent as a whole by up to `bent` of its length.
Mark thread(const ThingPlace& p, Random& random, double length, double width, double bent) {
  Mark m = p.at;
  m.shape = MarkShape::line;
  m.half_width = p.pixel * width / 2;
  m.half_length = p.pixel * length / 2;
  m.softness = 0.3 * p.pixel;
  m.bend = random.uniform(-bent, bent) / m.half_length;
  m.twist = random.uniform(-bent, bent) / (m.half_length * m.half_length);
  m.strength = part(random, 0.7, 1);
  m.groove = -part(random, 0.2, 0.9);
  return m;
}

/// What a thing at some height over the surface hides from the lamp.
Mark shadow_of(const ThingPlace& p, Mark m, double height, float dark) {
  const double facing = std::max(0.2, p.lamp.dot(p.at.normal));
  m.point -= height / facing * (p.lamp - p.lamp.dot(p.at.normal) * p.at.normal);
  m.shadow = true;
  m.strength = dark;
  m.softness += 0.3 * height;
  m.groove = 0;
  return m;
}

/// The things after their shadows, all of one height.
std::vector<Mark> over_shadows(const ThingPlace& p, const std::vector<Mark>& things, double height,
                               float dark) {
  std::vector<Mark> marks;
  for (const Mark& m : things) marks.push_back(shadow_of(p, m, height, dark));
  marks.insert(marks.end(), things.begin(), things.end());
  return marks;
}

}  // namespace

std::vector<Mark> hair(const ThingPlace& p, Random& random) {
  const Rgb color = thing_color(random);
  const double length = p.size * random.uniform(0.1, 0.7), width = random.uniform(0.8, 3);
  Mark m = thread(p, random, length, width, 0.35);
  m.color = color;
  m.taper = random.uniform(0, 0.5);
  const double height = p.pixel * random.uniform(0, 8);
  return over_shadows(p, {m}, height, part(random, 0.1, 0.6));
}

std::vector<Mark> twig(const ThingPlace& p, Random& random) {
  const Rgb color = thing_color(random);
  const double length = p.size * random.uniform(0.1, 0.5), width = random.uniform(1.5, 6);
  std::vector<Mark> things{thread(p, random, length, width, 0.12)};
  const auto branches = random.below(4);
  for (std::uint64_t i = 0; i < branches; ++i) {
    const double angle = (random.below(2) ? 1 : -1) * random.uniform(0.4, 1.1);
    const double share = random.uniform(0.2, 0.5);
    const double from = random.uniform(-0.7, 0.7) * things[0].half_length;
    ThingPlace q = p;
    q.at.along = turned(p.at, angle);
    q.at.point += from * p.at.along +
                  (things[0].bend * from * from) * p.at.normal.cross(p.at.along) +
                  share * things[0].half_length * q.at.along;
    things.push_back(thread(q, random, share * length, 0.6 * width, 0.1));
  }
  for (Mark& m : things) {
    m.color = color;
    m.taper = 0.6;
  }
  const double height = p.pixel * random.uniform(1, 6);
  return over_shadows(p, things, height, part(random, 0.2, 0.6));
}

std::vector<Mark> grass(const ThingPlace& p, Random& random) {
  const float light = part(random, 0.08, 0.4), dry = part(random, 0, 1);
  const Rgb color(light * (0.5f + 0.5f * dry), light, light * (0.3f + 0.3f * dry));
  std::vector<Mark> things;
  const auto blades = 2 + random.below(5);
  for (std::uint64_t i = 0; i < blades; ++i) {
    const double length = p.size * random.uniform(0.05, 0.25), width = random.uniform(1, 4);
    ThingPlace q = p;
    q.at.along = turned(p.at, random.uniform(0, 2 * std::numbers::pi));
    q.at.point += p.pixel * length / 2 * q.at.along;
    things.push_back(thread(q, random, length, width, 0.25));
    things.back().color = part(random, 0.7, 1.3) * color;
    things.back().taper = random.uniform(0.5, 1);
  }
  const double height = p.pixel * random.uniform(1, 8);
  return over_shadows(p, things, height, part(random, 0.15, 0.5));
}

std::vector<Mark> rod(const ThingPlace& p, Random& random) {
  const Rgb color = thing_color(random);
  const double length = p.size * random.uniform(0.3, 3), width = random.uniform(1, 6);
  Mark m = thread(p, random, length, width, 0.02);
  m.color = color;
  const double height = p.size * p.pixel * random.uniform(0, 0.2);
  return over_shadows(p, {m}, height, part(random, 0.2, 0.7));
}

std::vector<Mark> pebble(const ThingPlace& p, Random& random) {
  Mark m = p.at;
  m.shape = MarkShape::blob;
  m.color = thing_color(random);
  m.half_width = p.pixel * p.size * random.uniform(0.006, 0.03);
  m.half_length = m.half_width * random.uniform(1, 1.6);
  m.softness = 0.5 * p.pixel;
  m.unevenness = m.half_width * random.uniform(0.05, 0.3);
  m.groove = -part(random, 0.5, 1);
  const double height = m.half_width * random.uniform(0.4, 1);
  return over_shadows(p, {m}, height, part(random, 0.3, 0.7));
}

}  // namespace craze
