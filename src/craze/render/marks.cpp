#include "craze/render/marks.h"

#include <algorithm>
#include <cmath>

#include "craze/render/noise.h"

namespace craze::render {

namespace {

/// How far outside the mark's edge a place is, and the way across the edge there.
struct Edge {
  float outside = 0;
  Vec3f across = Vec3f::Zero();
  float from_middle = 0;  ///< of a line, signed
};

Edge edge_of(const Mark& mark, const Vec3f& place) {
  const Vec3f off = place - mark.point.cast<float>();
  const Vec3f along = mark.along.cast<float>(), normal = mark.normal.cast<float>();
  Edge edge;
  edge.across = normal.cross(along);
  const float s = off.dot(along), side = off.dot(edge.across);
  float uneven = 0;
  if (mark.unevenness > 0) {
    const auto size = static_cast<float>(mark.unevenness);
    uneven = size * fractal_noise(place / (4 * size), 3).value;
  }
  switch (mark.shape) {
    case MarkShape::line: {
      edge.from_middle = side - static_cast<float>(mark.bend) * s * s;
      edge.outside = std::max(std::abs(edge.from_middle) - static_cast<float>(mark.half_width),
                              std::abs(s) - static_cast<float>(mark.half_length));
      break;
    }
    case MarkShape::blob:
      edge.outside = (off - off.dot(normal) * normal).norm() - static_cast<float>(mark.half_width);
      break;
    case MarkShape::half:
      edge.outside = side;
      break;
  }
  edge.outside += uneven;
  return edge;
}

}  // namespace

std::vector<Mark> scaled(std::vector<Mark> marks, const Vec3& origin, double scale) {
  for (Mark& m : marks) {
    m.point = scale * (m.point - origin);
    m.bend /= scale;
    for (double* length : {&m.half_width, &m.half_length, &m.softness, &m.unevenness, &m.depth}) {
      *length *= scale;
    }
  }
  return marks;
}

MarkSample marks_at(const std::vector<Mark>& marks, const Vec3f& place, float footprint) {
  MarkSample sample;
  for (const Mark& mark : marks) {
    const Vec3 off = place.cast<double>() - mark.point;
    if (std::abs(off.dot(mark.normal)) > mark.depth) continue;
    const Edge edge = edge_of(mark, place);
    const float soft = std::max(static_cast<float>(mark.softness), 0.5f * footprint);
    const float inside = 1 - smoothstep(-soft, soft, edge.outside);
    if (inside <= 0) continue;
    if (mark.shape == MarkShape::half) {
      sample.light *= 1 - mark.strength * inside;
      continue;
    }
    const float part = mark.strength * inside;
    sample.color = (1 - part) * sample.color + part * mark.color;
    sample.cover += part * (1 - sample.cover);
    const auto half = static_cast<float>(mark.half_width);
    if (mark.groove > 0 && half > 0) {
      sample.tilt -=
          mark.groove * inside * std::clamp(edge.from_middle / half, -1.0f, 1.0f) * edge.across;
    }
  }
  return sample;
}

}  // namespace craze::render
