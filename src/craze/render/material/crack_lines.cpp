#include "craze/render/material/crack_lines.h"

#include <limits>

namespace craze::render {

CrackLines crack_lines(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides,
                       double reach, const Context& context) {
  CrackLines lines;
  lines.cracks = nearby_cracks(mesh, sides, reach, context);
  return lines;
}

void set_widths(CrackLines& lines, const std::vector<std::int32_t>& sides,
                const std::vector<std::array<float, 2>>& width) {
  lines.width.clear();
  lines.width.reserve(lines.cracks.segments.size());
  for (const NearbyCrack& s : lines.cracks.segments) {
    const auto side = std::lower_bound(sides.begin(), sides.end(), s.halfedge);
    lines.width.push_back(width[static_cast<std::size_t>(side - sides.begin())]);
  }
}

LinePainter::LinePainter(const CrackLines& lines, const Vec3& origin, double scale,
                         double half_width)
    : first_(lines.cracks.first), open_(lines.open) {
  segments_.reserve(lines.cracks.segments.size());
  for (std::size_t i = 0; i < lines.cracks.segments.size(); ++i) {
    const NearbyCrack& s = lines.cracks.segments[i];
    const double squared_length = scale * scale * (s.b - s.a).squaredNorm();
    const auto unit = static_cast<float>(half_width);
    const std::array<float, 2> width =
        lines.width.empty() ? std::array<float, 2>{1, 1} : lines.width[i];
    segments_.push_back({(scale * (s.a - origin)).cast<float>(),
                         (scale * (s.b - s.a)).cast<float>(),
                         squared_length > 0 ? static_cast<float>(1 / squared_length) : 0.0f,
                         unit * width[0], unit * width[1]});
  }
}

LineSample LinePainter::at(std::int32_t f, const Vec3f& point, float footprint) const {
  LineSample sample;
  if (static_cast<std::size_t>(f) + 1 >= first_.size()) return sample;
  float nearest = std::numeric_limits<float>::max();
  for (std::int32_t i = first_[f]; i < first_[f + 1]; ++i) {
    const Segment& s = segments_[i];
    const Vec3f from_a = point - s.a;
    const float t = std::clamp(from_a.dot(s.along) * s.inverse_squared_length, 0.0f, 1.0f);
    const Vec3f away = from_a - t * s.along;
    const float distance = away.norm();
    const float w = s.half_width_a + t * (s.half_width_b - s.half_width_a);
    if (w > 0 && distance < nearest) {
      nearest = distance;
      sample.away = away;
    }
    if (w <= 0 || distance > 2 * static_cast<float>(reach) * w + footprint) continue;

    const float fade = std::max(0.0f, 1 - distance / (2 * static_cast<float>(reach) * w));
    sample.stain = std::max(sample.stain, fade * fade * fade);
    if (open_) {
      const float slope = 1 - smoothstep(0, 2.5f * w, distance);
      if (distance > 0 && slope * slope > sample.tilt.squaredNorm()) {
        sample.tilt = -slope / distance * away;
      }
      continue;
    }
    const float drawn = std::max(w, 0.45f * footprint);
    const float soft = std::max(0.5f * drawn, 0.25f * footprint);
    const float core = (w / drawn) * (1 - smoothstep(drawn - soft, drawn + soft, distance));
    if (core > sample.core || (core == sample.core && sample.tilt.isZero())) {
      const float slope = smoothstep(0, 0.8f * w, distance) *
                          (1 - smoothstep(0.8f * w, 2.2f * w, distance)) * (w / drawn);
      sample.tilt = distance > 0 ? Vec3f(-slope / distance * away) : Vec3f(Vec3f::Zero());
    }
    sample.core = std::max(sample.core, core);
  }
  return sample;
}

}  // namespace craze::render
