#include "craze/job/maps/write_maps.h"

#include "craze/job/maps/map_files.h"
#include "craze/products/maps/bake_surface.h"
#include "craze/products/maps/map_surface.h"

namespace craze {

namespace {

using Sets = std::map<std::int32_t, std::size_t>;

std::vector<std::string> write(const MapSurface& surface, const Sets& uv_sets,
                               const MapsRequest& request, const Context& context) {
  MapFiles files(request, uv_sets, context);
  std::vector<std::string> warnings = bake_surface(surface, request.options, files, context);
  files.write_description(nlohmann::ordered_json::object());
  return warnings;
}

}  // namespace

std::vector<std::string> write_maps(const Result& result, const MapsRequest& request,
                                    const Context& context) {
  return write(map_surface(result, request.options.post, context), {}, request, context);
}

std::vector<std::string> write_maps(const Result& result, const SceneUvs& uvs,
                                    const MapsRequest& request, const Context& context) {
  if (uvs.is_first_alone()) return write_maps(result, request, context);
  MapSurface surface = map_surface(result, uvs.surface, request.options.post, context);
  surface.apart = true;
  return write(surface, uvs.set, request, context);
}

std::vector<std::string> write_maps(const SurfaceMesh& cracked, const MapsRequest& request,
                                    const Context& context) {
  return write(map_surface(cracked, request.options.post, context), {}, request, context);
}

}  // namespace craze
