#include "craze/products/maps/groove_sizes.h"

#include <algorithm>
#include <cmath>

#include "craze/base/text/format.h"
#include "craze/engine/width_by_age.h"
#include "craze/mesh/bounding_diagonal.h"

namespace craze {

namespace {

/// [IO06 Eq. 9] γ that makes the mean opening over the cracks' length gap_width.
double gap_of(const MapSurface& maps, const WidthByAge& by_age, double gap_width) {
  double length = 0, opening = 0;
  for (const MapCrack& crack : maps.cracks) {
    const double of_crack = (crack.b - crack.a).norm();
    length += of_crack;
    for (std::size_t end = 0; end < 2; ++end) {
      opening += of_crack / 2 * crack.width[end] * by_age.factor(crack.times[end]);
    }
  }
  return opening > 0 ? gap_width * (length / opening) : 0;
}

/// No groove is wider than cracks are apart: nothing would be left between them.
void limit_widths(GrooveSizes& sizes, double distance) {
  if (!(distance > 0)) return;
  bool is_limited = false;
  for (std::array<double, 2>& half : sizes.half_width) {
    for (double& h : half) {
      is_limited = is_limited || !(h <= distance / 2);
      if (!(h <= distance / 2)) h = distance / 2;
    }
  }
  if (!is_limited) return;
  sizes.warnings.push_back(fmt::format(
      "cracks are at most as wide in maps as they are apart on average, {:.3g}: post.gap or "
      "post.gap_width asks for more",
      distance));
}

/// Nothing is deeper or lifted higher than the surface is large: more shows nothing more.
void limit_heights(GrooveSizes& sizes, double diagonal) {
  double widest = 0;
  for (const std::array<double, 2>& half : sizes.half_width) {
    widest = std::max({widest, half[0], half[1]});
  }
  if (sizes.wall > diagonal) {
    sizes.wall = diagonal;
    sizes.warnings.push_back(fmt::format(
        "cracks in maps are {:.3g} deep, as much as the surface is large: post.wall asks for more",
        diagonal));
  }
  const double lift = std::abs(sizes.curl) * widest;
  if (lift > diagonal) {
    sizes.curl = std::copysign(diagonal / widest, sizes.curl);
    sizes.warnings.push_back(fmt::format(
        "rims in maps are lifted by {:.3g}, as much as the surface is large: post.curl asks for "
        "more",
        diagonal));
  }
}

}  // namespace

std::vector<std::array<double, 2>> half_widths(const std::vector<MapCrack>& cracks, double gap,
                                               double late_width) {
  const WidthByAge by_age = width_by_age(late_width, cracks);
  std::vector<std::array<double, 2>> halves;
  for (const MapCrack& crack : cracks) {
    std::array<double, 2> half{};
    for (std::size_t end = 0; end < 2; ++end) {
      half[end] = gap * crack.width[end] / 2 * by_age.factor(crack.times[end]);
    }
    halves.push_back(half);
  }
  return halves;
}

GrooveSizes groove_sizes(const MapSurface& maps, const PostParameters& post) {
  GrooveSizes sizes;
  sizes.wall = post.wall;
  sizes.curl = post.curl;
  const double diagonal =
      maps.diagonal > 0 ? maps.diagonal : bounding_diagonal(maps.surface.positions);
  const double gap_width = post.gap_width;
  const double line = (gap_width > 0 ? gap_width : hairline * diagonal) / 2;
  const WidthByAge by_age = width_by_age(post.late_width, maps.cracks);
  double gap = maps.has_widths ? post.gap : 0;
  if (maps.has_widths && gap_width > 0) gap = gap_of(maps, by_age, gap_width);
  if (gap > 0) {
    sizes.half_width = half_widths(maps.cracks, gap, post.late_width);
  } else {
    for (const MapCrack& crack : maps.cracks) {
      sizes.half_width.push_back(
          {line * by_age.factor(crack.times[0]), line * by_age.factor(crack.times[1])});
    }
  }
  const double distance = mean_crack_distance(maps);
  limit_widths(sizes, distance);
  limit_heights(sizes, diagonal);
  if (post.chipping > 0) {
    sizes.chips =
        place_chips(maps.cracks, sizes.half_width, chip_options(post, distance, maps.seed));
    sizes.warnings.insert(sizes.warnings.end(), sizes.chips.warnings.begin(),
                          sizes.chips.warnings.end());
  }
  return sizes;
}

}  // namespace craze
