// Curves laid onto an asset: from point to point along its faces.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/curve_sites.h"
#include "craze/engine/asset/shortest_way.h"
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
  std::int32_t rerouted = 0;  ///< curve edges that no plane led straight across
  std::int32_t lost = 0;      ///< curve edges given up: gaps between parts
  double lost_length = 0;     ///< of their chords
};

/// Lays curve edges onto the asset. Between two points that no face holds both, the way is where
/// the plane through their chord and their mean normal meets the surface, from face to face over
/// edges with exactly two faces; which edge is left through depends on signs at vertices alone, so
/// the walk never slips between faces. Where that leads astray (a border, an edge of three faces,
/// a way half as long again as the chord) the shortest way over the faces is taken if it is
/// shorter, and what has none either is given up.
class CurveTracer {
 public:
  /// The asset's vertices may lie elsewhere than for `sites`: on the surface where the curves are
  /// to be straight. usual_chord: the mean length of curve edges. No way is longer than four times
  /// the chord, or than four times this where the chord is shorter. Where the asset repeats it must
  /// be flat: no shortest way is looked for.
  CurveTracer(const SurfaceMesh& asset, const AssetTopology& topology, SiteTable& sites,
              double usual_chord);

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

  double walk(std::int32_t from, std::int32_t to, const Vec3& normal, std::int32_t curve_edge,
              std::vector<CurvePiece>& pieces);
  void follow(const SurfaceWay& way, std::int32_t from, std::int32_t to, std::int32_t curve_edge,
              std::vector<CurvePiece>& pieces);
  Step best_step(std::int32_t site, std::int32_t last_face, const Vec3& origin, const Vec3& across,
                 const Vec3& target) const;
  Vec3 place_of(std::int32_t site) const { return sites_.position(site, asset_.positions); }
  /// From one place to another, the shortest.
  Vec3 way(const Vec3& from, const Vec3& to) const { return sites_.period().shortest(to - from); }
  Vec3 area_normal(std::int32_t face) const;
  Vec3 normal(std::int32_t site) const;

  const SurfaceMesh& asset_;
  const AssetTopology& topology_;
  SiteTable& sites_;
  double usual_chord_;
  ShortestWay shortest_way_;
  TraceReport report_;
};

}  // namespace craze
