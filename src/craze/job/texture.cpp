#include "craze/job/texture.h"

#include <filesystem>

#include "craze/job/maps/map_files.h"
#include "craze/job/tile_preview.h"
#include "craze/material/material.h"
#include "craze/products/maps/bake_surface.h"
#include "craze/products/maps/map_description.h"
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

}  // namespace

Report make_texture(const TextureRequest& request, const Context& context) {
  MapsRequest maps = request.maps;
  if (maps.options.maps.empty()) maps.options.maps = texture_maps();
  TileTextures::check(maps.options);
  const TileTextures made(request.recipe, request.tile, context);
  MapFiles files(maps, {}, context);
  made.bake(maps.options, files, context);
  if (request.previews) write_previews(made, request, context);
  files.write_description(tile_json(made, request.tile));
  return made.tile().report;
}

}  // namespace craze
