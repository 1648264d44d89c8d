#include "craze/job/texture.h"

#include <filesystem>

#include "craze/job/maps/map_files.h"
#include "craze/job/tile_preview.h"
#include "craze/material/material.h"
#include "craze/products/maps/bake_surface.h"
#include "craze/products/maps/tile_textures.h"
#include "craze/render/png.h"

namespace craze {

namespace {

constexpr int preview_texels = 384;

void write_previews(const TileTextures& made, const TextureRequest& request,
                    const Context& context) {
  MapOptions options;
  options.size = preview_texels;
  options.maps = {MapKind::height, MapKind::base_color};
  std::vector<Map> maps;
  MapsInMemory sink(maps);
  made.bake(options, sink, context);
  const render::Material& material = render::find_material(made.tile().recipe.picture.material);
  const auto write = [&](const char* name, const SurfaceMesh& mesh) {
    const std::filesystem::path path = std::filesystem::path(request.maps.folder) / name;
    render::write_png(path.string(), tile_picture(mesh, maps[1], material, context), context);
  };
  write("preview_plane.png", tiled_plane(maps[0], request.tile.side));
  write("preview_sphere.png", tiled_sphere(maps[0], request.tile.side));
}

nlohmann::ordered_json describe(const TileTextures& made, const TextureRequest& request) {
  nlohmann::ordered_json tile;
  tile["side"] = request.tile.side;
  tile["metres_per_unit"] = request.tile.metres_per_unit > 0
                                ? nlohmann::ordered_json(request.tile.metres_per_unit)
                                : nullptr;
  tile["seed"] = made.tile().recipe.simulation.seed;
  tile["material"] = made.tile().recipe.picture.material;
  tile["gap"] = made.grooves().gap;
  tile["wall"] = static_cast<double>(made.grooves().wall);
  tile["pieces"] = made.tile().report.cracks.fragments;
  tile["crack_length"] = made.tile().report.cracks.length;
  nlohmann::ordered_json json;
  json["tile"] = tile;
  return json;
}

}  // namespace

Report make_texture(const TextureRequest& request, const Context& context) {
  MapsRequest maps = request.maps;
  if (maps.options.maps.empty()) maps.options.maps = texture_maps();
  TileTextures::check(maps.options);
  const TileTextures made(request.recipe, request.tile, context);
  MapFiles files(maps, {}, context);
  made.bake(maps.options, files, context);
  if (request.previews) write_previews(made, request, context);
  files.write_description(describe(made, request));
  return made.tile().report;
}

}  // namespace craze
