#include "craze/job/texture.h"

#include <algorithm>
#include <filesystem>

#include "craze/error.h"
#include "craze/job/maps/map_files.h"
#include "craze/job/output_folder.h"
#include "craze/job/tile_look.h"
#include "craze/job/tile_preview.h"
#include "craze/products/maps/bake_surface.h"
#include "craze/products/maps/groove_sampler.h"
#include "craze/products/maps/tile_surface.h"
#include "craze/render/png.h"

namespace craze {

namespace {

constexpr int preview_texels = 384;

/// A tile and all that its maps are made of.
struct Textured {
  CrackedTile tile;
  MapSurface surface;
  PostParameters grooves;
  TileMaterial material;
  double stain_width;
};

double mean_width(const MapSurface& maps, double gap) {
  double sum = 0;
  for (const MapCrack& crack : maps.cracks) sum += (crack.width[0] + crack.width[1]) / 2;
  return maps.cracks.empty() ? 0 : gap * sum / static_cast<double>(maps.cracks.size());
}

Textured textured(const TextureRequest& request, const Context& context) {
  Textured made;
  made.tile = crack_tile(request.recipe, request.tile, context);
  made.surface = tile_surface(made.tile);
  made.grooves = tile_grooves(made.tile);
  made.material = tile_material(made.tile.recipe);
  made.stain_width =
      std::max(mean_width(made.surface, made.grooves.gap), hairline * made.surface.diagonal);
  return made;
}

void bake(const Textured& made, MapOptions options, MapSink& sink, const Context& context) {
  const std::vector<MapKind> asked = options.maps;
  options.maps = MaterialMaps::baked(asked);
  options.post = made.grooves;
  options.by_material = true;  // no tiles: what leaves the square comes in on the other side
  MaterialMaps maps(made.material, made.stain_width, made.tile.recipe.simulation.seed, asked, sink,
                    context);
  bake_surface(made.surface, options, maps, context);
}

void write_previews(const Textured& made, const TextureRequest& request, const Context& context) {
  MapOptions options;
  options.size = preview_texels;
  options.maps = {MapKind::height, MapKind::base_color};
  std::vector<Map> maps;
  MapsInMemory sink(maps);
  bake(made, options, sink, context);
  const render::Material& material = render::find_material(made.tile.recipe.picture.material);
  const auto write = [&](const char* name, const SurfaceMesh& mesh) {
    const std::filesystem::path path = std::filesystem::path(request.maps.folder) / name;
    render::write_png(path.string(), tile_picture(mesh, maps[1], material, context), context);
  };
  write("preview_plane.png", tiled_plane(maps[0], request.tile.side));
  write("preview_sphere.png", tiled_sphere(maps[0], request.tile.side));
}

nlohmann::ordered_json describe(const Textured& made, const TextureRequest& request) {
  nlohmann::ordered_json tile;
  tile["side"] = request.tile.side;
  tile["metres_per_unit"] = request.tile.metres_per_unit > 0
                                ? nlohmann::ordered_json(request.tile.metres_per_unit)
                                : nullptr;
  tile["seed"] = made.tile.recipe.simulation.seed;
  tile["material"] = made.tile.recipe.picture.material;
  tile["gap"] = made.grooves.gap;
  tile["wall"] = static_cast<double>(made.grooves.wall);
  tile["pieces"] = made.tile.report.cracks.fragments;
  tile["crack_length"] = made.tile.report.cracks.length;
  nlohmann::ordered_json json;
  json["tile"] = tile;
  return json;
}

}  // namespace

const std::vector<MapKind>& texture_maps() {
  static const std::vector<MapKind> kinds{MapKind::base_color, MapKind::normal,    MapKind::height,
                                          MapKind::occlusion,  MapKind::roughness, MapKind::mask,
                                          MapKind::fragment};
  return kinds;
}

Report make_texture(const TextureRequest& request, const Context& context) {
  MapsRequest maps = request.maps;
  std::vector<MapKind>& kinds = maps.options.maps;
  if (kinds.empty()) kinds = texture_maps();
  if (std::find(kinds.begin(), kinds.end(), MapKind::position) != kinds.end()) {
    throw Error(ErrorKind::usage, "tiles have no such map", "position", "it is u and v");
  }
  const Textured made = textured(request, context);
  MapFiles files(maps, context);
  bake(made, maps.options, files, context);
  if (request.previews) write_previews(made, request, context);
  files.write_description(describe(made, request));
  return made.tile.report;
}

}  // namespace craze
