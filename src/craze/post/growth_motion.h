// The surface as it opens, crack by crack.
#pragma once

#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/post/crack_schedule.h"
#include "craze/post/opening.h"

namespace craze {

/// How the vertices of an opened mesh get from the shut surface to their places. The sides of a
/// crack part as it comes by; where a later crack will start from an open one, the two corners that
/// it will separate move as one until then. Between cracks vertices go when the cracks around them
/// have come, on average. The bottoms of side walls do not move.
class GrowthMotion {
 public:
  /// `opened` was made of `mesh`.
  GrowthMotion(const TriangleMesh& mesh, const CrackSites& sites, const CrackSchedule& schedule,
               const OpenedMesh& opened);

  /// #V of the opened mesh, at a time of the clip: the shut surface at 0, the opened mesh at 1.
  std::vector<Vec3> positions(double time) const;

 private:
  /// One of the shifts that a vertex makes, one after the other.
  struct Shift {
    std::int32_t vertex;
    double arrival;
    Vec3 by;
  };

  void part_at_sites(const TriangleMesh& mesh, const CrackSites& sites,
                     const CrackSchedule& schedule, const std::vector<Vec3>& whole);

  std::vector<Vec3> shut_;
  std::vector<Shift> shifts_;
};

}  // namespace craze
