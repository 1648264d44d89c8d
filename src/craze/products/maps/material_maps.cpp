#include "craze/products/maps/material_maps.h"

#include <algorithm>
#include <cassert>

#include "craze/base/elementary.h"
#include "craze/base/parallel.h"
#include "craze/base/random.h"
#include "craze/products/maps/rows_at_once.h"

namespace craze {

namespace {

constexpr std::int32_t cloud_cells = 5;  // of the widest clouds, a side
constexpr int cloud_octaves = 8;
constexpr double piece_tint = 0.16;  // as pictures have it: render/surface.cpp
constexpr double uneven = 0.5;       // of the clouds, in roughness

bool is_of_material(MapKind kind) {
  return kind == MapKind::base_color || kind == MapKind::roughness;
}

bool contains(const std::vector<MapKind>& kinds, MapKind kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

}  // namespace

MaterialMaps::MaterialMaps(const TileMaterial& material, double stain_width, std::uint64_t seed,
                           const std::vector<MapKind>& asked, MapSink& onward,
                           const Context& context)
    : material_(material),
      stain_width_(stain_width),
      seed_(seed),
      asked_(asked),
      onward_(onward),
      context_(context),
      clouds_(seed, cloud_cells, cloud_octaves),
      baked_(baked(asked)) {
  assert(stain_width > 0);
}

std::vector<MapKind> MaterialMaps::baked(const std::vector<MapKind>& asked) {
  std::vector<MapKind> kinds;
  const auto add = [&](MapKind kind) {
    if (!contains(kinds, kind)) kinds.push_back(kind);
  };
  for (const MapKind kind : asked) {
    if (!is_of_material(kind)) add(kind);
  }
  if (std::any_of(asked.begin(), asked.end(), is_of_material)) add(MapKind::mask);
  if (contains(asked, MapKind::base_color)) {
    add(MapKind::distance);
    add(MapKind::fragment);
    add(MapKind::time);
  }
  return kinds;
}

std::size_t MaterialMaps::place_of(MapKind kind) const {
  const auto at = std::find(baked_.begin(), baked_.end(), kind);
  return static_cast<std::size_t>(at - baked_.begin());
}

void MaterialMaps::begin(const std::vector<MapHeader>& headers) {
  size_ = headers[0].size;
  if (contains(asked_, MapKind::base_color)) {
    const MapHeader& time = headers[place_of(MapKind::time)];
    tone_ = {material_.late, time.low[0], time.high[0]};
  }
  std::vector<MapHeader> own;
  for (const MapKind kind : asked_) {
    if (is_of_material(kind)) {
      MapHeader header = headers[0];
      header.kind = kind;
      header.low.fill(0);
      header.high.fill(1);
      own.push_back(header);
    } else {
      own.push_back(headers[place_of(kind)]);
    }
  }
  onward_.begin(own);
}

void MaterialMaps::rows(int first, int count, const std::vector<const float*>& maps) {
  const auto texels = static_cast<std::size_t>(count) * static_cast<std::size_t>(size_);
  if (contains(asked_, MapKind::base_color)) color_.resize(3 * texels);
  if (contains(asked_, MapKind::roughness)) roughness_.resize(texels);
  if (!color_.empty() || !roughness_.empty()) {
    parallel_for(context_.threads, static_cast<std::size_t>(count), rows_at_once,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t r = begin; r < end; ++r) {
                     compose(first + static_cast<int>(r), r * static_cast<std::size_t>(size_),
                             maps);
                   }
                 });
  }
  std::vector<const float*> own;
  for (const MapKind kind : asked_) {
    own.push_back(kind == MapKind::base_color  ? color_.data()
                  : kind == MapKind::roughness ? roughness_.data()
                                               : maps[place_of(kind)]);
  }
  onward_.rows(first, count, own);
}

void MaterialMaps::compose(int y, std::size_t at, const std::vector<const float*>& maps) {
  const float* mask = maps[place_of(MapKind::mask)] + at;
  const float *distance = nullptr, *fragment = nullptr, *time = nullptr;
  if (!color_.empty()) {
    distance = maps[place_of(MapKind::distance)] + at;
    fragment = maps[place_of(MapKind::fragment)] + at;
    time = maps[place_of(MapKind::time)] + at;
  }
  for (int x = 0; x < size_; ++x) {
    const double share = mask[x];
    const double cloud = clouds_.at({(x + 0.5) / size_, (y + 0.5) / size_});
    if (!roughness_.empty()) {
      const double own =
          std::clamp(material_.roughness + uneven * material_.mottle * cloud, 0.0, 1.0);
      roughness_[at + x] = static_cast<float>(own + share * (1 - own));
    }
    if (color_.empty()) continue;
    const Random random(seed_, static_cast<std::uint64_t>(fragment[x]));
    const double tone = tone_.factor(time[x]);
    const double beside = distance[x] / stain_width_;
    const double tint = (1 + material_.mottle * cloud +
                         piece_tint * material_.pieces * (random.uniform_at(0) - 0.5)) *
                        (1 - tone * material_.stain * elementary::exp(-beside * beside));
    for (std::size_t c = 0; c < 3; ++c) {
      const double own = std::clamp(tint * material_.color[c], 0.0, 1.0);
      color_[3 * (at + static_cast<std::size_t>(x)) + c] =
          static_cast<float>(own + tone * share * (material_.wall[c] - own));
    }
  }
}

}  // namespace craze
