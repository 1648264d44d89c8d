#include "craze/maps.h"

#include "craze/error.h"
#include "craze/products/maps/bake_surface.h"

namespace craze {

void MapsInMemory::begin(const std::vector<MapHeader>& headers) {
  first_ = maps_.size();
  for (const MapHeader& header : headers) {
    const auto size = static_cast<std::size_t>(header.size);
    maps_.push_back({header, {}});
    maps_.back().values.reserve(size * size * map_info(header.kind).channels);
  }
}

void MapsInMemory::rows(int, int count, const std::vector<const float*>& maps) {
  for (std::size_t m = 0; m < maps.size(); ++m) {
    Map& map = maps_[first_ + m];
    const std::size_t n =
        static_cast<std::size_t>(count) * map.header.size * map_info(map.header.kind).channels;
    map.values.insert(map.values.end(), maps[m], maps[m] + n);
  }
}

void check_uvs(const SurfaceMesh& surface) {
  if (!surface.corner_uvs.empty()) return;
  throw Error(ErrorKind::request, "cannot bake maps", "uv", "the mesh has no UVs; unwrap it first");
}

std::vector<std::string> bake_maps(const Result& result, const MapOptions& options, MapSink& sink,
                                   const Context& context) {
  return bake_surface(map_surface(result, options.post, context), options, sink, context);
}

std::vector<std::string> bake_maps(const SurfaceMesh& cracked, const MapOptions& options,
                                   MapSink& sink, const Context& context) {
  return bake_surface(map_surface(cracked, options.post, context), options, sink, context);
}

std::vector<Map> baked_maps(const Result& result, const MapOptions& options,
                            std::vector<std::string>& warnings, const Context& context) {
  std::vector<Map> maps;
  MapsInMemory sink(maps);
  warnings = bake_maps(result, options, sink, context);
  return maps;
}

}  // namespace craze
