// Maps of a run.
#include "callback_context.h"
#include "craze/products/maps/bake_surface.h"
#include "craze/products/maps/map_description.h"
#include "craze/products/maps/tile_textures.h"
#include "guard.h"
#include "handles.h"

using namespace craze;
using namespace craze::c;

namespace {

/// The maps of a list with commas; none where it is null.
std::vector<MapKind> kinds_of(const char* names, bool of_tile = false) {
  std::vector<MapKind> kinds;
  if (!names) return kinds;
  const std::string list = names;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    kinds.push_back(find_map(list.substr(begin, end - begin), of_tile));
    begin = end + 1;
  }
  return kinds;
}

std::unique_ptr<craze_maps> new_maps(
    std::vector<Map> maps, std::vector<std::string> warnings,
    const nlohmann::ordered_json& more = nlohmann::ordered_json::object()) {
  auto made = std::make_unique<craze_maps>();
  made->maps = std::move(maps);
  made->warnings = std::move(warnings);
  nlohmann::ordered_json described = nlohmann::ordered_json::array();
  for (const Map& map : made->maps) {
    made->names.push_back(map_name(map.header));
    described.push_back(map_json(map.header, MapFormat::exr));
  }
  made->description = maps_text(MapFormat::exr, more, described);
  return made;
}

/// Throws Error(usage) where there is none.
const Map& map_at(const craze_maps* maps, int64_t i) {
  require(maps, "maps");
  if (i < 0 || i >= static_cast<int64_t>(maps->maps.size())) {
    wrong_argument("no such map", "i", "craze_maps_name() says which there are");
  }
  return maps->maps[static_cast<std::size_t>(i)];
}

}  // namespace

craze_maps* craze_job_bake(const craze_job* job, int32_t size, const char* names, int32_t green_up,
                           double gap, double wall, craze_error* error) {
  return guarded(error, [&] {
    require(job, "job");
    if (!job->result) wrong_argument("nothing to bake", "job", "craze_job_run() comes first");
    MapOptions options;
    options.size = size;
    options.maps = kinds_of(names);
    options.green_up = green_up != 0;
    options.post = job->result->report().recipe.post;
    options.post.gap = gap;
    options.post.wall = wall;
    const CallbackContext context(*job);
    std::vector<std::string> warnings;
    std::vector<Map> maps = baked_maps(*job->result, options, warnings, context.get());
    return new_maps(std::move(maps), std::move(warnings)).release();
  });
}

craze_maps* craze_job_texture(const craze_job* job, const char* period, int32_t size,
                              const char* names, int32_t green_up, craze_error* error) {
  return guarded(error, [&] {
    require(job, "job");
    require(period, "period");
    MapOptions options;
    options.size = size;
    options.maps = kinds_of(names, true);
    options.green_up = green_up != 0;
    TileTextures::check(options);
    const CallbackContext context(*job);
    const TileSize tile = read_tile_size(period);
    const TileTextures made(job->recipe, tile, context.get());
    std::vector<Map> maps;
    MapsInMemory sink(maps);
    made.bake(options, sink, context.get());
    return new_maps(std::move(maps), made.tile().report.warnings, tile_json(made, tile)).release();
  });
}

void craze_maps_free(craze_maps* maps) {
  delete maps;
}

const char* craze_maps_name(const craze_maps* maps, int64_t i) {
  return maps ? text_at(maps->names, i) : nullptr;
}

craze_status craze_maps_array(const craze_maps* maps, int64_t i, craze_array* array,
                              craze_error* error) {
  return guard(error, [&] {
    const Map& map = map_at(maps, i);
    require(array, "array");
    const int channels = map_info(map.header.kind).channels;
    *array = {map.values.data(), static_cast<int64_t>(map.values.size()) / channels, channels,
              CRAZE_FLOAT32};
  });
}

craze_status craze_maps_range(const craze_maps* maps, int64_t i, double low[3], double high[3],
                              craze_error* error) {
  return guard(error, [&] {
    const Map& map = map_at(maps, i);
    require(low, "low");
    require(high, "high");
    const double largest = 65535;
    const bool ids = map_info(map.header.kind).values == MapValues::id;  // stored as they are
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = ids ? 0 : map.header.low[k];
      high[k] = ids ? largest : map.header.high[k];
    }
  });
}

const char* craze_maps_description(const craze_maps* maps) {
  return maps ? maps->description.c_str() : nullptr;
}

const char* craze_maps_warning(const craze_maps* maps, int64_t i) {
  return maps ? text_at(maps->warnings, i) : nullptr;
}
