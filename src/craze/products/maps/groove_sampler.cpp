#include "craze/products/maps/groove_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "craze/products/maps/groove.h"

namespace craze {

namespace {

constexpr int parts = 2;  // of a texel along each side
/// Texels around a face, and around one at the border of an island, that it is asked for.
constexpr double inside_margin = 1, border_margin = texels_followed + 2;
/// The same at most, over the mean length of the cracks' pieces: where texels are so large that a
/// map cannot show the cracks, faces need not see them all.
constexpr double most_inside = 0.5, most_at_border = 2;
constexpr std::size_t most_near = 32;  // lines that one texel is looked at for
constexpr std::int32_t lines_of_block = 16;
/// Boxes are farther than the lines in them by roundings only, which this is above.
constexpr double above_rounding = 1 + 1e-9;

double extent_of(const Chips& chips, std::size_t crack) {
  return chips.extent.empty() ? 0 : chips.extent[crack];
}

}  // namespace

GrooveSampler::GrooveSampler(const MapSurface& maps, const MapFaces& faces,
                             const std::vector<std::uint8_t>& at_border, const GrooveSizes& sizes,
                             int size, const Context& context)
    : sizes_(sizes) {
  double total = 0;
  for (const MapCrack& crack : maps.cracks) total += (crack.b - crack.a).norm();
  const double mean = maps.cracks.empty() ? 0 : total / static_cast<double>(maps.cracks.size());
  SightLimits limits;
  for (std::size_t f = 0; f < maps.surface.triangles.size(); ++f) {
    const double texel = faces.texel(static_cast<std::int32_t>(f), size);
    limits.margin.push_back(at_border[f] ? std::min(border_margin * texel, most_at_border * mean)
                                         : std::min(inside_margin * texel, most_inside * mean));
  }
  for (std::size_t i = 0; i < sizes.half_width.size(); ++i) {
    const auto& [a, b] = sizes.half_width[i];
    limits.reach.push_back(std::max({a, b, extent_of(sizes.chips, i)}));
  }
  find_fragments(maps);
  SeenCracks seen = seen_cracks(maps, limits, context);
  for (const SeenCrack& s : seen.cracks) {
    const double squared = (s.b - s.a).squaredNorm();
    const auto& [a, b] = sizes.half_width[s.crack];
    lines_.push_back({s.a, s.b - s.a, squared > 0 ? 1 / squared : 0, a, b, s.crack});
  }
  first_ = std::move(seen.first);
  make_blocks(maps.surface.triangles.size());
  for (const double d : seen.farthest) farthest_ = std::max(farthest_, d);
}

double GrooveSampler::Block::squared_distance(const Vec2& p) const {
  return (p - p.cwiseMax(low).cwiseMin(high)).squaredNorm();
}

void GrooveSampler::make_blocks(std::size_t faces) {
  first_block_.push_back(0);
  for (std::size_t f = 0; f < faces; ++f) {
    for (std::int32_t i = first_[f]; i < first_[f + 1]; i += lines_of_block) {
      Block block{lines_[i].a, lines_[i].a, 0, 0, i, std::min(i + lines_of_block, first_[f + 1])};
      for (std::int32_t k = block.first; k < block.last; ++k) {
        const Line& line = lines_[k];
        block.low = block.low.cwiseMin(line.a).cwiseMin(line.a + line.along);
        block.high = block.high.cwiseMax(line.a).cwiseMax(line.a + line.along);
        block.widest = std::max({block.widest, line.half_width_a, line.half_width_b});
        block.chipped =
            std::max(block.chipped, extent_of(sizes_.chips, static_cast<std::size_t>(line.crack)));
      }
      blocks_.push_back(block);
    }
    first_block_.push_back(static_cast<std::int32_t>(blocks_.size()));
  }
}

GrooveSampler::Foot GrooveSampler::foot(const Line& line, const Vec2& p) {
  const Vec2 from_a = p - line.a;
  const double t = std::clamp(from_a.dot(line.along) * line.inverse_squared_length, 0.0, 1.0);
  const Vec2 away = from_a - t * line.along;
  return {t, std::sqrt(away.squaredNorm()),
          line.half_width_a + t * (line.half_width_b - line.half_width_a), away};
}

double GrooveSampler::squared_distance(const Line& line, const Vec2& p) {
  const Vec2 from_a = p - line.a;
  const double t = std::clamp(from_a.dot(line.along) * line.inverse_squared_length, 0.0, 1.0);
  return (from_a - t * line.along).squaredNorm();
}

NearestCrack GrooveSampler::nearest(std::int32_t face, const Vec2& p) const {
  NearestCrack nearest{std::numeric_limits<double>::infinity(), -1, 0, Vec2::Zero(), Vec2::Zero()};
  double least = nearest.distance;
  const Line* line = nullptr;
  for (std::int32_t b = first_block_[face]; b < first_block_[face + 1]; ++b) {
    const Block& block = blocks_[b];
    if (block.squared_distance(p) > least * above_rounding) continue;
    for (std::int32_t i = block.first; i < block.last; ++i) {
      const double squared = squared_distance(lines_[i], p);
      if (squared < least || (squared == least && line && lines_[i].crack < line->crack)) {
        least = squared;
        line = &lines_[i];
      }
    }
  }
  if (!line) return nearest;
  const Foot there = foot(*line, p);
  nearest = {there.distance, line->crack, there.along, line->along, p - there.away};
  return nearest;
}

GrooveMean GrooveSampler::mean(std::int32_t face, const Vec2& p, const Mat2& texel, double lift,
                               std::int32_t fragment) const {
  const double size = texel.col(0).norm() + texel.col(1).norm();
  std::array<const Line*, most_near> near;
  std::array<double, most_near> above;  // the distance over the half width, of each
  std::size_t count = 0;
  for (std::int32_t b = first_block_[face]; b < first_block_[face + 1]; ++b) {
    const Block& block = blocks_[b];
    const double reach = block.widest + size;
    if (block.squared_distance(p) > reach * reach * above_rounding) continue;
    for (std::int32_t i = block.first; i < block.last; ++i) {
      const Line& line = lines_[i];
      // The half width changes along the line, the more so where a tip tapers off.
      const double widest = std::max(line.half_width_a, line.half_width_b);
      const double squared = squared_distance(line, p);
      if (!(widest > 0 && squared < (widest + size) * (widest + size))) continue;
      std::size_t slot = count;
      const double over = std::sqrt(squared) - widest;
      if (count < most_near) {
        ++count;
      } else {  // in place of the one that matters least
        slot =
            static_cast<std::size_t>(std::max_element(above.begin(), above.end()) - above.begin());
        if (over >= above[slot]) continue;
      }
      near[slot] = &line;
      above[slot] = over;
    }
  }
  std::vector<LaidChip> chips;
  for_each_chip(face, p, size, [&](const LaidChip& chip) {
    if (chip.fragment < 0 || chip.fragment == fragment) chips.push_back(chip);
  });
  GrooveMean sum;
  sum.height = lift;
  if (count == 0 && chips.empty()) return sum;
  sum.height = 0;
  sum.light = 0;
  for (int part = 0; part < parts * parts; ++part) {
    const Vec2 shift((part % parts + 0.5) / parts - 0.5, (part / parts + 0.5) / parts - 0.5);
    const Vec2 q = p + texel * shift;
    double mask = 0, height = 0, light = 1;
    for (std::size_t i = 0; i < count; ++i) {
      const Line& line = *near[i];
      const Foot there = foot(line, q);
      if (there.half_width <= 0 || there.distance > there.half_width + size) continue;
      // Across the line a texel's box is nearly one whose width has the same second moment.
      Vec2 across = there.away;
      if (there.distance <= 0) across = Vec2(-line.along.y(), line.along.x());
      const double length = std::sqrt(across.squaredNorm());
      if (length <= 0) continue;
      const Vec2 extent = texel.transpose() * across / (length * parts);
      const double width = std::sqrt(extent.squaredNorm());
      if (width <= 0) continue;
      const double share = covered_share(there.distance, there.half_width, width);
      const double depth = sizes_.depth(there.half_width) + std::max(lift, 0.0);
      mask = std::max(mask, share);
      height = std::min(height, -depth * mean_depth(there.distance, there.half_width, width));
      light =
          std::min(light, 1 - share * (1 - groove_light(there.distance, there.half_width, depth)));
    }
    for (const LaidChip& laid : chips) {
      const Vec2 at = laid.flat(q);
      if (at.y() < 0) continue;
      const Vec2 in_chip(at.x(), at.y() - laid.half_width);
      const double inside = 1 - laid.chip->outline(in_chip);
      const double ramp = size / (2 * parts) / std::min(laid.chip->reach, laid.chip->inwards);
      const double share = std::clamp(0.5 + inside / ramp, 0.0, 1.0);
      if (share <= 0) continue;
      mask = std::max(mask, share);
      height = std::min(height, -laid.chip->depth_at(in_chip));
    }
    sum.mask += mask;
    sum.height += height;
    sum.light += light;
  }
  constexpr double all = parts * parts;
  return {sum.mask / all, lift + sum.height / all, sum.light / all};
}

Vec2 GrooveSampler::LaidChip::flat(const Vec2& p) const {
  const Vec2 d = p - middle;
  return {d.dot(x), d.dot(y)};
}

template <class Visit>
void GrooveSampler::for_each_chip(std::int32_t face, const Vec2& p, double margin,
                                  Visit&& visit) const {
  const Chips& chips = sizes_.chips;
  if (chips.first.empty()) return;
  for (std::int32_t b = first_block_[face]; b < first_block_[face + 1]; ++b) {
    const Block& block = blocks_[b];
    const double far = block.chipped + margin;
    if (block.chipped <= 0 || block.squared_distance(p) > far * far * above_rounding) continue;
    for (std::int32_t i = block.first; i < block.last; ++i) {
      const Line& line = lines_[i];
      const double reach = extent_of(chips, static_cast<std::size_t>(line.crack)) + margin;
      if (squared_distance(line, p) > reach * reach) continue;
      for (std::int32_t k = chips.first[line.crack]; k < chips.first[line.crack + 1]; ++k) {
        const Chip& chip = chips.chips[k];
        const double length = std::sqrt(line.along.squaredNorm()), share = chip.along / length;
        LaidChip laid{&chip, &line, line.a + share * line.along, line.along / length, {}, 0, -1};
        laid.y = chip.left ? Vec2(-laid.x.y(), laid.x.x()) : Vec2(laid.x.y(), -laid.x.x());
        laid.half_width = line.half_width_a + share * (line.half_width_b - line.half_width_a);
        laid.fragment = fragments_[line.crack][chip.left ? 0 : 1];
        const double of_chip = std::max(chip.reach, laid.half_width + chip.inwards) + margin;
        if ((p - laid.middle).squaredNorm() <= of_chip * of_chip) visit(laid);
      }
    }
  }
}

void GrooveSampler::find_fragments(const MapSurface& maps) {
  fragments_.assign(maps.cracks.size(), {-1, -1});
  if (sizes_.chips.first.empty() || !maps.cut) return;
  const auto sides = sides_of_cracks(maps.cracks, *maps.cut);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const std::int32_t h = sides[i][k].halfedge;
      if (h >= 0) fragments_[i][k] = maps.pieces[h / 3].fragment;
    }
  }
}

double GrooveSampler::width(std::int32_t face, const NearestCrack& nearest) const {
  if (nearest.crack < 0) return 0;
  const auto& [a, b] = sizes_.half_width[nearest.crack];
  const double half = a + nearest.along * (b - a);
  if (sizes_.chips.first.empty()) return 2 * half;
  std::array<double, 2> chipped{0, 0};  // right and left
  for_each_chip(face, nearest.foot, 0, [&](const LaidChip& laid) {
    const bool left = laid.y.x() * nearest.direction.y() < laid.y.y() * nearest.direction.x();
    const double in = laid.chip->inwards_at(laid.flat(nearest.foot).x());
    chipped[left] = std::max(chipped[left], in);
  });
  return 2 * half + chipped[0] + chipped[1];
}

}  // namespace craze
