// How far a crack's line may move aside before it meets another one, itself or the border.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "craze/base/cell_grid.h"
#include "craze/engine/roughness/crack_chains.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/crack_network.h"

namespace craze {

/// A place on a crack that is to move along normal × tangent.
struct MovingPlace {
  Vec3 position, normal, tangent;  ///< unit vectors
  std::int32_t chain;
  double arc;  ///< of the chain
};

/// Lines moved by less than their room, each point across its own line, stay apart: what two of
/// them have together is less than the distance between the lines as they were, and a line that
/// turns has less than the radius of its turn.
class CrackRoom {
 public:
  /// reach: what is farther does not count. near: parts of one chain that are nearer along it are
  /// neighbours, not obstacles. `mesh` gives the border, which faces of source faces that are
  /// closed (rough_network.h) have as well.
  CrackRoom(const CrackNetwork& network, const std::vector<CrackChain>& chains,
            const TriangleMesh& mesh, const std::vector<std::uint8_t>& closed, double reach,
            double near);

  /// In 0 … reach.
  double around(const MovingPlace& place) const;

 private:
  struct Obstacle {
    Vec3 a, b;
    Vec3 normal;         // of the surface there; zero: not known
    std::int32_t chain;  // −1: the border
    double arc;          // of its chain, in the middle
  };
  static std::vector<Obstacle> obstacles_of(const CrackNetwork& network,
                                            const std::vector<CrackChain>& chains,
                                            const TriangleMesh& mesh,
                                            const std::vector<std::uint8_t>& closed);
  double room_beside(const Obstacle& obstacle, const MovingPlace& place, const Vec3& seen) const;

  Period period_;
  double reach_, near_;
  std::vector<Obstacle> obstacles_;
  double far_;  // from where the middle of an obstacle may count
  CellGrid grid_;
  std::unordered_map<std::uint64_t, std::vector<std::int32_t>> cells_;  // by the middle
};

}  // namespace craze
