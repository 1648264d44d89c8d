// The short way between two points of an asset where no plane leads straight across.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/curve_sites.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Out of a face over one of its edges.
struct Crossing {
  std::int32_t face;
  std::int32_t halfedge;  ///< of that face
  double share;           ///< along the halfedge, 0 … 1
};

/// From the first crossing's face to last_face, straight inside each.
struct SurfaceWay {
  std::vector<Crossing> crossings;
  std::int32_t last_face = -1;  ///< −1: there is no way
  double length = 0;
};

/// Finds the strip of faces, over edges with exactly two of them, along which a way near the chord
/// between two sites is shortest, and pulls the way tight in the strip laid out flat: it bends at
/// vertices of the strip alone. Expected O(n log n) in the number of edges whose detour is not
/// longer than the way found. The asset must outlive this.
class ShortestWay {
 public:
  ShortestWay(const SurfaceMesh& asset, const AssetTopology& topology, const SiteTable& sites)
      : asset_(asset), topology_(topology), sites_(sites) {}

  /// The sites have no face in common. No way if none of at most `most`, a length, was found.
  SurfaceWay find(std::int32_t from, std::int32_t to, double most);

 private:
  // An edge reached, by the halfedge that leads out of the strip so far.
  struct Reached {
    double cost;            // from the start to `at`
    std::int32_t halfedge;  // of the face that the way comes through
    std::int32_t before;    // the edge before, −1: the start
    Vec3 at;                // the edge's point nearest to the chord
    bool done = false;
  };
  using Entry = std::tuple<double, std::int32_t>;  // (cost + distance to the target, edge)

  void reach(std::int32_t h, std::int32_t before, const Vec3& here, double cost);
  bool is_on(std::int32_t site, std::int32_t h) const;
  std::int32_t face_beyond(std::int32_t h) const;
  Vec3 place_of(std::int32_t site) const { return sites_.position(site, asset_.positions); }
  Vec3 nearest_to_chord(std::int32_t h) const;
  void pull_tight(std::int32_t from, std::int32_t to, SurfaceWay& way) const;

  const SurfaceMesh& asset_;
  const AssetTopology& topology_;
  const SiteTable& sites_;
  // The present search.
  Vec3 start_ = Vec3::Zero(), target_ = Vec3::Zero();
  double most_ = 0;
  std::unordered_map<std::int32_t, Reached> reached_;  // by edge; never walked through
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace craze
