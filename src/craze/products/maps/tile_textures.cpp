#include "craze/products/maps/tile_textures.h"

#include <algorithm>

#include "craze/error.h"
#include "craze/products/maps/bake_surface.h"
#include "craze/products/maps/groove_sampler.h"
#include "craze/products/maps/tile_look.h"
#include "craze/products/maps/tile_surface.h"

namespace craze {

namespace {

double mean_width(const MapSurface& maps, double gap) {
  double sum = 0;
  for (const MapCrack& crack : maps.cracks) sum += (crack.width[0] + crack.width[1]) / 2;
  return maps.cracks.empty() ? 0 : gap * sum / static_cast<double>(maps.cracks.size());
}

}  // namespace

const std::vector<MapKind>& texture_maps() {
  static const std::vector<MapKind> kinds{MapKind::base_color, MapKind::normal,    MapKind::height,
                                          MapKind::occlusion,  MapKind::roughness, MapKind::mask,
                                          MapKind::fragment};
  return kinds;
}

void TileTextures::check(const MapOptions& options) {
  const auto& asked = options.maps;
  if (std::find(asked.begin(), asked.end(), MapKind::position) != asked.end()) {
    throw Error(ErrorKind::usage, "tiles have no such map", "position", "it is u and v");
  }
  MapOptions baked = options;
  baked.maps = MaterialMaps::baked(asked);
  check_map_options(baked);
}

TileTextures::TileTextures(const Recipe& recipe, const TileSize& size, const Context& context)
    : tile_(crack_tile(recipe, size, context)),
      surface_(tile_surface(tile_)),
      grooves_(tile_grooves(tile_)),
      material_(tile_material(tile_.recipe)),
      stain_width_(std::max(mean_width(surface_, grooves_.gap), hairline * surface_.diagonal)) {}

void TileTextures::bake(MapOptions options, MapSink& sink, const Context& context) const {
  check(options);
  const std::vector<MapKind> asked = options.maps.empty() ? texture_maps() : options.maps;
  options.maps = MaterialMaps::baked(asked);
  options.post = grooves_;
  options.by_material = true;  // no tiles: what leaves the square comes in on the other side
  MaterialMaps maps(material_, stain_width_, tile_.recipe.simulation.seed, asked, sink, context);
  bake_surface(surface_, options, maps, context);
}

}  // namespace craze
