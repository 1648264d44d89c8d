// What has not opened yet goes along with the open cracks beside it.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"

namespace craze {

/// Keeps a surface that opens crack by crack from being pushed through what still waits: a vertex
/// that is free to move goes so far with its neighbours that no edge at it changes by more than a
/// part of its length. The vertices of a crack that has not come yet move as one.
class Drag {
 public:
  Drag(const TriangleMesh& mesh, const CrackSites& sites);

  /// `move` (#V): how far the vertices have gone by themselves, 0 where a crack has not come yet;
  /// what they are dragged is added. `slack` (#V, 0 … 1, the same on a site): the part of the drag
  /// that each follows. The result changes continuously with both.
  void along(const std::vector<double>& slack, std::vector<Vec3>& move) const;

 private:
  struct Neighbour {
    std::int32_t vertex;
    double slackness;  ///< difference of the moves that needs no drag, length
  };

  /// The vertices of a node move as one; one node per site and per vertex away from cracks.
  std::vector<std::int32_t> node_of_;                  // #V
  std::vector<std::int32_t> vertices_, first_vertex_;  // by node
  std::vector<Neighbour> neighbours_;                  // by node
  std::vector<std::int32_t> first_neighbour_;
};

}  // namespace craze
