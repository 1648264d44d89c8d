// The maps of one picture, row by row.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/maps.h"
#include "craze/products/maps/groove_sampler.h"
#include "craze/products/maps/lift/map_lift.h"
#include "craze/products/maps/map_faces.h"
#include "craze/products/maps/map_surface.h"
#include "craze/products/maps/uv_layout.h"

namespace craze {

/// Everything that the sheets of a surface share.
struct BakeScene {
  const MapSurface& maps;
  const MapFaces& faces;
  const GrooveSizes& sizes;
  const GrooveSampler& grooves;
  const MapLift& lift;
  const std::vector<std::int32_t>& islands;   ///< #F: uv_islands.h
  const std::vector<double>& base_curvature;  ///< #V, mean; empty: not asked for
  const MapOptions& options;
};

/// Bakes `sheet` into `sink`, from begin() to end(). `headers` are those of begin(). Reports
/// "maps".
void bake_sheet(const BakeScene& scene, const MapSheet& sheet,
                const std::vector<MapHeader>& headers, MapSink& sink, const Context& context);

}  // namespace craze
