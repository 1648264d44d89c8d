// The surface as it opens, crack by crack.
#pragma once

#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_schedule.h"
#include "craze/products/growth/drag.h"
#include "craze/products/opening/opening.h"

namespace craze {

/// How the vertices of an opened mesh get from the shut surface to their places. The sides of a
/// crack part as it comes by; where a later crack will start from an open one, the two corners that
/// it will separate move as one until then. Between cracks vertices go when the cracks around them
/// have come, on average; what has not gone yet is dragged along by what has (drag.h). Side walls
/// go down as their cracks open; those along the input's border are there from the start. The inner
/// surfaces of solids go with what is above them; cores stay.
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

  /// Where the bottom of a wall is when its crack is shut.
  struct Bottom {
    std::int32_t vertex;  ///< of the opened mesh
    std::int32_t top;     ///< of the cut mesh
    Vec3 down;            ///< from the top, shut, to its place
  };

  void add_bottoms(const TriangleMesh& mesh, const CrackSites& sites, const OpenedMesh& opened);
  void part_at_sites(const TriangleMesh& mesh, const CrackSites& sites,
                     const CrackSchedule& schedule, const std::vector<Vec3>& whole);

  std::vector<Vec3> shut_;
  std::vector<Shift> shifts_;
  std::vector<double> arrival_;  // #V of the cut mesh
  std::vector<Bottom> bottoms_;
  std::vector<Bottom> inner_;  // of solids: always as far below their tops
  std::vector<WallPoint> wall_points_;
  bool goes_down_ = false;  // walls do, as cracks open
  Drag drag_;
};

}  // namespace craze
