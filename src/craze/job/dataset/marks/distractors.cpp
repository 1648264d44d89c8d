#include "craze/job/dataset/marks/distractors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "craze/base/elementary.h"
#include "craze/base/random.h"
#include "craze/job/dataset/marks/strewn_things.h"

namespace craze {

namespace {

using render::Mark;
using render::MarkShape;

/// A mark's place, with the size of a pixel there.
struct Place {
  Mark mark;
  double pixel;
};

class Strewer {
 public:
  Strewer(const SurfaceMesh& mesh, const render::RayScene& rays, const Projection& projection,
          std::uint64_t seed)
      : mesh_(mesh), rays_(rays), projection_(projection), random_(seed, 0x6d61726b) {}

  /// None where many rays meet nothing.
  std::optional<Place> place() {
    constexpr int tries = 32;
    for (int i = 0; i < tries; ++i) {
      const double x = random_.uniform(0, projection_.width());
      const double y = random_.uniform(0, projection_.height());
      const double turn = random_.uniform(0, 2 * std::numbers::pi);
      const render::Hit hit = rays_.intersect(projection_.ray(x, y));
      if (hit.face < 0) continue;
      const Triangle& t = mesh_.triangles[hit.face];
      const Vec3 &a = mesh_.positions[t[0]], &b = mesh_.positions[t[1]], &c = mesh_.positions[t[2]];
      Place place;
      place.mark.point =
          a + static_cast<double>(hit.u) * (b - a) + static_cast<double>(hit.v) * (c - a);
      place.mark.normal = (b - a).cross(c - a).stableNormalized();
      const Vec3 first = place.mark.normal.unitOrthogonal();
      place.mark.along =
          elementary::cos(turn) * first + elementary::sin(turn) * place.mark.normal.cross(first);
      place.pixel = projection_.pixel_size(projection_.depth(place.mark.point));
      // Not through to the far side of what is thick.
      place.mark.depth = 0.1 / projection_.scale();
      return place;
    }
    return std::nullopt;
  }

  Random& random() { return random_; }
  double between(double low, double high) { return random_.uniform(low, high); }
  double size() const { return std::sqrt(1.0 * projection_.width() * projection_.height()); }

 private:
  const SurfaceMesh& mesh_;
  const render::RayScene& rays_;
  const Projection& projection_;
  Random random_;
};

Mark shadow(Strewer& s, Place p) {
  p.mark.shape = MarkShape::half;
  p.mark.shadow = true;
  p.mark.softness = p.pixel * s.between(0.5, 0.03 * s.size());
  p.mark.unevenness = p.pixel * s.between(0, 0.1 * s.size());
  p.mark.strength = static_cast<float>(s.between(0.25, 0.65));
  return p.mark;
}

Mark stain(Strewer& s, Place p, const render::Rgb& color) {
  p.mark.shape = MarkShape::blob;
  p.mark.half_width = p.pixel * s.size() * s.between(0.01, 0.12);
  p.mark.softness = p.mark.half_width * s.between(0.05, 0.5);
  p.mark.half_length = p.mark.half_width * s.between(1, 3);
  p.mark.unevenness = p.mark.half_width * s.between(0.2, 1.2);
  p.mark.color = static_cast<float>(s.between(0.15, 0.9)) * color;
  p.mark.strength = static_cast<float>(s.between(0.2, 0.8));
  return p.mark;
}

Mark line(Strewer& s, Place p, const render::Rgb& color, double half_width, double half_length) {
  p.mark.shape = MarkShape::line;
  p.mark.half_width = p.pixel * half_width;
  p.mark.half_length = p.pixel * half_length;
  p.mark.softness = p.pixel * s.between(0.2, 0.8);
  p.mark.color = color;
  return p.mark;
}

// Numbers are drawn one after the other, never between the arguments of a call.
Mark joint(Strewer& s, const Place& p, const render::Rgb& color) {
  const auto dark = static_cast<float>(s.between(0.2, 0.8));
  const double half_width = s.between(2, 7);
  Mark m = line(s, p, dark * color, half_width, 4 * s.size());
  m.strength = static_cast<float>(s.between(0.4, 0.95));
  m.groove = static_cast<float>(s.between(0.2, 0.9));
  return m;
}

Mark scratch(Strewer& s, const Place& p, const render::Rgb& color) {
  const double length = s.size() * s.between(0.02, 0.25);
  const auto light = static_cast<float>(s.between(0.6, 1.8));
  const double half_width = s.between(0.3, 1.1);
  Mark m = line(s, p, (light * color).min(0.95f), half_width, length);
  m.bend = s.between(-0.15, 0.15) / (p.pixel * length);
  m.strength = static_cast<float>(s.between(0.3, 0.9));
  return m;
}

Mark seam(Strewer& s, const Place& p, const render::Rgb& color) {
  const auto dark = static_cast<float>(s.between(0.05, 0.4));
  const double half_width = s.between(0.5, 1.6);
  Mark m = line(s, p, dark * color, half_width, 4 * s.size());
  m.strength = static_cast<float>(s.between(0.5, 0.95));
  return m;
}

/// Rubber: a broad, faint, dark band, as of a tyre.
Mark tyre(Strewer& s, const Place& p, const render::Rgb& color) {
  const auto dark = static_cast<float>(s.between(0.15, 0.6));
  const double half_width = s.size() * s.between(0.01, 0.08);
  Mark m = line(s, p, dark * color, half_width, 4 * s.size());
  m.bend = s.between(-0.1, 0.1) / (p.pixel * s.size());
  m.softness = m.half_width * s.between(0.2, 0.8);
  m.unevenness = m.half_width * s.between(0, 0.5);
  m.strength = static_cast<float>(s.between(0.15, 0.6));
  return m;
}

/// A painted line: broad, light or coloured, with worn edges.
Mark painted_line(Strewer& s, const Place& p) {
  const bool yellow = s.between(0, 1) < 0.3;
  const auto light = static_cast<float>(s.between(0.3, 0.9));
  const double half_width = s.between(2, 0.08 * s.size());
  Mark m = line(s, p, light * render::Rgb(1, yellow ? 0.7f : 1, yellow ? 0.2f : 0.97f), half_width,
                s.size() * s.between(0.3, 4));
  m.unevenness = std::min(m.half_width, p.pixel * s.between(0, 6));
  m.strength = static_cast<float>(s.between(0.4, 0.95));
  return m;
}

/// A row of signs of a few strokes each.
std::vector<Mark> lettering(Strewer& s, const Place& p, const render::Rgb& color) {
  const auto light = static_cast<float>(s.between(0.05, 2.5));
  const auto strength = static_cast<float>(s.between(0.5, 0.95));
  const double height = s.size() * s.between(0.02, 0.12);
  const double half_width = std::max(0.5, height * s.between(0.03, 0.1));
  const Vec3 up = p.mark.normal.cross(p.mark.along);
  const int signs = static_cast<int>(s.between(2, 8));
  std::vector<Mark> marks;
  for (int i = 0; i < signs; ++i) {
    const int strokes = static_cast<int>(s.between(1, 4));
    for (int k = 0; k < strokes; ++k) {
      Place q = p;
      const double right = height * (0.8 * i + s.between(-0.25, 0.25));
      const double above = height * s.between(-0.3, 0.3);
      // Mostly upright or level, as strokes of letters are.
      const double turn = std::numbers::pi / 4 * std::floor(s.between(0, 4));
      q.mark.point += p.pixel * (right * p.mark.along + above * up);
      q.mark.along = elementary::cos(turn) * p.mark.along + elementary::sin(turn) * up;
      const double half_length = height * s.between(0.2, 0.5);
      marks.push_back(line(s, q, (light * color).min(0.95f), half_width, half_length));
      marks.back().bend = s.between(-0.5, 0.5) / (p.pixel * half_length);
      marks.back().strength = strength;
    }
  }
  return marks;
}

}  // namespace

std::vector<Mark> strewn_marks(const PlanValues& values, const SurfaceMesh& mesh,
                               const render::RayScene& rays, const Projection& projection,
                               const render::Rgb& color, const Vec3& lamp, std::uint64_t seed) {
  std::vector<Mark> marks;
  std::uint64_t kind = 0;
  // Each kind draws by itself: more of one moves none of the others.
  const auto strew = [&](const char* key, const auto& make) {
    Strewer strewer(mesh, rays, projection, hash_bits(seed ^ ++kind));
    for (double i = number_of(values, key); i >= 1; --i) {
      const auto place = strewer.place();
      if (!place) continue;
      const std::vector<Mark> made = make(strewer, *place);
      marks.insert(marks.end(), made.begin(), made.end());
    }
  };
  const auto one = [&](const char* key, const auto& make) {
    strew(key, [&](Strewer& s, const Place& p) { return std::vector<Mark>(1, make(s, p)); });
  };
  const auto thing = [&](const char* key, const auto& make) {
    strew(key, [&](Strewer& s, const Place& p) {
      return make(ThingPlace{p.mark, p.pixel, s.size(), lamp}, s.random());
    });
  };
  one("distractors.stain", [&](Strewer& s, const Place& p) { return stain(s, p, color); });
  one("distractors.joint", [&](Strewer& s, const Place& p) { return joint(s, p, color); });
  one("distractors.seam", [&](Strewer& s, const Place& p) { return seam(s, p, color); });
  one("distractors.scratch", [&](Strewer& s, const Place& p) { return scratch(s, p, color); });
  one("distractors.shadow", [&](Strewer& s, const Place& p) { return shadow(s, p); });
  one("distractors.tyre", [&](Strewer& s, const Place& p) { return tyre(s, p, color); });
  one("distractors.painted_line", [&](Strewer& s, const Place& p) { return painted_line(s, p); });
  strew("distractors.lettering",
        [&](Strewer& s, const Place& p) { return lettering(s, p, color); });
  thing("distractors.pebble", pebble);
  thing("distractors.hair", hair);
  thing("distractors.twig", twig);
  thing("distractors.grass", grass);
  thing("distractors.rod", rod);
  return marks;
}

}  // namespace craze
