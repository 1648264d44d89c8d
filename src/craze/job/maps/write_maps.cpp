#include "craze/job/maps/write_maps.h"

#include "craze/job/maps/map_files.h"

namespace craze {

namespace {

template <class Source>
std::vector<std::string> write(const Source& source, const MapsRequest& request,
                               const Context& context) {
  MapFiles files(request, context);
  std::vector<std::string> warnings = bake_maps(source, request.options, files, context);
  files.write_description(nlohmann::ordered_json::object());
  return warnings;
}

}  // namespace

std::vector<std::string> write_maps(const Result& result, const MapsRequest& request,
                                    const Context& context) {
  return write(result, request, context);
}

std::vector<std::string> write_maps(const SurfaceMesh& cracked, const MapsRequest& request,
                                    const Context& context) {
  return write(cracked, request, context);
}

}  // namespace craze
