// All maps of a surface.
#pragma once

#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/maps.h"
#include "craze/products/maps/map_surface.h"

namespace craze {

/// Throws Error(usage) for options that bake_surface() would not take.
void check_map_options(const MapOptions& options);

/// As bake_maps() says, of what it is all made from. Throws Error(usage) for wrong options, and
/// Cancelled.
std::vector<std::string> bake_surface(const MapSurface& maps, MapOptions options, MapSink& sink,
                                      const Context& context);

/// Keeps the maps that come, after those that are there.
class MapsInMemory : public MapSink {
 public:
  explicit MapsInMemory(std::vector<Map>& maps) : maps_(maps) {}

  void begin(const std::vector<MapHeader>& headers) override;
  void rows(int first, int count, const std::vector<const float*>& maps) override;
  void end() override {}

 private:
  std::vector<Map>& maps_;
  std::size_t first_ = 0;
};

}  // namespace craze
