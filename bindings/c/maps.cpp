// Maps of a run.
#include "callback_context.h"
#include "guard.h"
#include "handles.h"

using namespace craze;
using namespace craze::c;

namespace {

/// The maps of a list with commas; none where it is null.
std::vector<MapKind> kinds_of(const char* names) {
  std::vector<MapKind> kinds;
  if (!names) return kinds;
  const std::string list = names;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    kinds.push_back(find_map(list.substr(begin, end - begin)));
    begin = end + 1;
  }
  return kinds;
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
    options.post.gap = gap;
    options.post.wall = wall;
    const CallbackContext context(*job);
    auto baked = std::make_unique<craze_maps>();
    baked->maps = baked_maps(*job->result, options, baked->warnings, context.get());
    for (const Map& map : baked->maps) baked->names.push_back(map_name(map.header));
    return baked.release();
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
    require(maps, "maps");
    require(array, "array");
    if (i < 0 || i >= static_cast<int64_t>(maps->maps.size())) {
      wrong_argument("no such map", "i", "craze_maps_name() says which there are");
    }
    const Map& map = maps->maps[static_cast<std::size_t>(i)];
    const int channels = map_info(map.header.kind).channels;
    *array = {map.values.data(), static_cast<int64_t>(map.values.size()) / channels, channels,
              CRAZE_FLOAT32};
  });
}

const char* craze_maps_warning(const craze_maps* maps, int64_t i) {
  return maps ? text_at(maps->warnings, i) : nullptr;
}
