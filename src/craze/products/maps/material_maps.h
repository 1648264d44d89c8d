// Base colour and roughness of a tile, from the maps of its cracks.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/tile_noise.h"
#include "craze/context.h"
#include "craze/engine/width_by_age.h"
#include "craze/maps.h"

namespace craze {

/// How a tile looks where it is whole, and in its cracks.
struct TileMaterial {
  Color color, wall;     ///< linear diffuse reflectance: of the surface, and in open cracks
  double mottle = 0;     ///< relative strength of the cloudy variation of the colour
  double pieces = 0;     ///< 0 … 1, how much one piece differs from the next
  double stain = 0;      ///< 0 … 1, darkening of the band beside a crack
  double late = 1;       ///< 0 … 1, what is left of wall and stain at the last crack to open
  double roughness = 1;  ///< 0 … 1, of the surface; an open crack has 1
};

/// Adds base_color and roughness to the maps that go by, of one picture in a set, and hands on
/// those that were asked for. References must outlive it.
class MaterialMaps : public MapSink {
 public:
  /// stain_width: of the band beside a crack, to 1/e, length > 0.
  MaterialMaps(const TileMaterial& material, double stain_width, std::uint64_t seed,
               const std::vector<MapKind>& asked, MapSink& onward, const Context& context);

  /// The maps that have to be baked for those asked for.
  static std::vector<MapKind> baked(const std::vector<MapKind>& asked);

  void begin(const std::vector<MapHeader>& headers) override;
  void rows(int first, int count, const std::vector<const float*>& maps) override;
  void end() override { onward_.end(); }

 private:
  std::size_t place_of(MapKind kind) const;
  void compose(int y, std::size_t at, const std::vector<const float*>& maps);

  const TileMaterial& material_;
  double stain_width_;
  std::uint64_t seed_;
  const std::vector<MapKind>& asked_;
  MapSink& onward_;
  const Context& context_;
  TileNoise clouds_;
  std::vector<MapKind> baked_;
  int size_ = 0;
  WidthByAge tone_{1};
  std::vector<float> color_, roughness_;  // of the rows that go by
};

}  // namespace craze
