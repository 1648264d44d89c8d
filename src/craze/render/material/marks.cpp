#include "craze/render/material/marks.h"

#include <algorithm>
#include <cmath>

#include "craze/render/material/noise.h"

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
  const auto half_width = static_cast<float>(mark.half_width);
  const auto half_length = static_cast<float>(mark.half_length);
  Edge edge;
  edge.across = normal.cross(along);
  const float s = off.dot(along), side = off.dot(edge.across);
  switch (mark.shape) {
    case MarkShape::line: {
      const float bent = static_cast<float>(mark.bend) + s * static_cast<float>(mark.twist);
      edge.from_middle = side - bent * s * s;
      const float way = half_length > 0 ? s / half_length : 0;
      const float half = half_width * (1 - static_cast<float>(mark.taper) * way * way);
      edge.outside = std::max(std::abs(edge.from_middle) - half, std::abs(s) - half_length);
      break;
    }
    case MarkShape::blob: {
      const Vec3f round =
          side * edge.across + (half_length > 0 ? half_width / half_length * s : s) * along;
      edge.from_middle = round.norm();
      edge.outside = edge.from_middle - half_width;
      if (edge.from_middle > 0) edge.across = round / edge.from_middle;
      break;
    }
    case MarkShape::half:
      edge.outside = side;
      break;
  }
  const auto uneven = static_cast<float>(mark.unevenness);
  // The noise stays within −1 … 1: far outside it need not be known.
  if (uneven > 0 && edge.outside < uneven + static_cast<float>(mark.softness)) {
    edge.outside += uneven * fractal_noise(place / (4 * uneven), 3).value;
  }
  return edge;
}

}  // namespace

std::vector<Mark> scaled(std::vector<Mark> marks, const Vec3& origin, double scale) {
  for (Mark& m : marks) {
    m.point = scale * (m.point - origin);
    m.bend /= scale;
    m.twist /= scale * scale;
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
    if (mark.shadow) {
      sample.light *= 1 - mark.strength * inside;
      continue;
    }
    const float part = mark.strength * inside;
    sample.color = (1 - part) * sample.color + part * mark.color;
    sample.cover += part * (1 - sample.cover);
    const auto half = static_cast<float>(mark.half_width);
    if (mark.groove != 0 && half > 0) {
      sample.tilt -=
          mark.groove * inside * std::clamp(edge.from_middle / half, -1.0f, 1.0f) * edge.across;
    }
  }
  return sample;
}

}  // namespace craze::render
