// The nearest point of the asset's own sheet, not of the wall behind it.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/period.h"
#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/curve_sites.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Finds points near a place that is known, by way of neighbouring faces: a point of a thin wall
/// stays on its side however near the other one is. The asset must outlive this.
class SheetSearch {
 public:
  SheetSearch(const SurfaceMesh& asset, const AssetTopology& topology, const Period& period = {})
      : asset_(asset), topology_(topology), period_(period), seen_(asset.triangles.size(), 0) {}

  /// The point nearest to p among those that a walk from face `start` reaches: downhill, then over
  /// all faces joined to the place found that reach into the ball up to it, at most 512.
  SurfacePoint find(const Vec3& p, std::int32_t start);

 private:
  struct Place {
    SurfacePoint at;
    double distance;
  };
  Place nearest_in(const Vec3& p, std::int32_t face) const;
  template <class Visit>
  void for_each_neighbour(std::int32_t face, Visit&& visit) const;
  bool step_down(const Vec3& p, Place& place) const;

  const SurfaceMesh& asset_;
  const AssetTopology& topology_;
  Period period_;
  std::vector<std::int32_t> seen_;  // #F: the search that last came by
  std::int32_t search_ = 0;
  std::vector<std::int32_t> queue_;
};

}  // namespace craze
