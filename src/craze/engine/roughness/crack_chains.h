// A network's cracks from junction to junction.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "craze/model/crack_network.h"
#include "craze/tensor.h"

namespace craze {

/// Edges end to end; what lies between them are bends.
struct CrackChain {
  std::vector<std::int32_t> nodes;  ///< one more than edges; of a ring the first is the last too
  std::vector<std::int32_t> edges;
  double length = 0;
};

/// Every edge of the network is in one chain. A chain ends at tips, junctions and borders; a ring
/// starts anywhere. The same network gives the same order.
std::vector<CrackChain> crack_chains(const CrackNetwork& network);

/// The mean length of the chain that a point of a crack lies on.
double usual_length(const std::vector<CrackChain>& chains);

/// A place on a chain.
struct ChainPlace {
  Vec3 position;
  Vec3 normal;        ///< of the surface, unit
  std::size_t index;  ///< into `edges`: the one that holds it
};

/// A chain by its arc length, as one line: of a period its nodes are the images that follow each
/// other.
class ChainLine {
 public:
  ChainLine(const CrackChain& chain, const CrackNetwork& network);

  double length() const { return arc_.back(); }
  /// s in 0 … length().
  ChainPlace at(double s) const;
  /// The mean direction within `reach` on both sides, as far as the line goes; not unit.
  Vec3 direction(double s, double reach) const {
    return at(std::min(s + reach, length())).position - at(std::max(s - reach, 0.0)).position;
  }
  /// Arc length at the start of an edge.
  double start(std::size_t index) const { return arc_[index]; }
  const Vec3& point(std::size_t node) const { return points_[node]; }

 private:
  std::vector<double> arc_;  // per node
  std::vector<Vec3> points_, normals_;
};

}  // namespace craze
