// Curves laid onto an asset: from point to point along its faces.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/curve_sites.h"
#include "craze/mesh/closest_point.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Curves given by points of the asset. Curves that share a point meet there; a point without edges
/// is a point to be in the mesh.
struct CrackCurves {
  std::vector<SurfacePoint> points;
  std::vector<std::array<std::int32_t, 2>> edges;  ///< point indices
};

/// A straight piece of a curve edge inside one face or along its border, between two sites.
struct CurvePiece {
  std::int32_t face;
  std::int32_t from, to;  ///< sites
  std::int32_t curve_edge;
};

struct TraceReport {
  std::int32_t halved = 0;  ///< pieces that no plane led across, taken by halves
  std::int32_t lost = 0;    ///< pieces given up: gaps between parts, folds back onto themselves
  double lost_length = 0;   ///< of their chords
};

/// Lays curve edges onto the asset. Between two points that no face holds both, the way is where
/// the plane through their chord and their mean normal meets the surface, from face to face over
/// edges with exactly two faces; which edge is left through depends on signs at vertices alone, so
/// the walk never slips between faces. Where that leads astray (a border, an edge of three faces,
/// away from the chord) the chord is halved at the asset's point nearest to its middle, a few times
/// over, and what still fails is given up.
class CurveTracer {
 public:
  CurveTracer(const SurfaceMesh& asset, const AssetTopology& topology, SiteTable& sites);

  /// Adds the pieces of a curve edge between two sites, in order. Nothing where they are one.
  void trace(std::int32_t from, std::int32_t to, std::int32_t curve_edge,
             std::vector<CurvePiece>& pieces);
  const TraceReport& report() const { return report_; }

 private:
  struct Step {
    std::int32_t face = -1;
    std::int32_t halfedge = -1;  // that the plane crosses, at share
    double share = 0;
    double ahead = -2;  // cosine between the way to the crossing and the way to the target
  };

  void trace(std::int32_t from, std::int32_t to, std::int32_t curve_edge, int depth,
             std::vector<CurvePiece>& pieces);
  bool walk(std::int32_t from, std::int32_t to, const Vec3& normal, std::int32_t curve_edge,
            std::vector<CurvePiece>& pieces);
  Step best_step(std::int32_t site, std::int32_t last_face, const Vec3& origin, const Vec3& across,
                 const Vec3& target) const;
  std::int32_t middle(std::int32_t from, std::int32_t to);
  Vec3 area_normal(std::int32_t face) const;
  Vec3 normal(std::int32_t site) const;

  const SurfaceMesh& asset_;
  const AssetTopology& topology_;
  SiteTable& sites_;
  std::unique_ptr<ClosestPoint> tree_;  // made when first wanted
  TraceReport report_;
};

}  // namespace craze
