// The cracks of a finished run as a graph on the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/model/failure/healed_cracks.h"
#include "craze/model/simulation.h"
#include "craze/tensor.h"

namespace craze {

/// How many crack edges meet at a node, and where it lies.
enum class JunctionKind : std::int32_t {
  end = 0,       ///< one edge, inside the surface: a tip
  bend = 1,      ///< two edges: the inside of a crack
  junction = 2,  ///< three or more
  border = 3,    ///< on the border of the input
};

struct CrackNode {
  Vec3 position;
  Vec3 normal;             ///< unit, of the surface there
  std::int32_t face = -1;  ///< an input triangle (source face) that holds the node
  JunctionKind kind = JunctionKind::bend;
  std::int32_t vertex = -1;  ///< of the cut mesh: one of those that lie on the node
};

struct CrackEdge {
  std::int32_t a = -1, b = -1;  ///< node indices; the crack grew from a to b
  double time = 0;              ///< load factor s (or simulated time, euler) at which it opened
  double width = 0;             ///< opening of Eq. 9 with γ = 1, averaged over the edge, length
  std::int32_t event = 0;       ///< the crack event that made it, counted from 0
  std::int32_t face = -1;       ///< an input triangle that holds the edge
  std::int32_t side = -1;       ///< of the cut mesh: the shortest side of the crack that holds it
};

/// Edges meet only at nodes: a crack that ends on another one splits it there.
struct CrackNetwork {
  std::vector<CrackNode> nodes;
  std::vector<CrackEdge> edges;
  Period period;  ///< of the mesh

  /// From node v to node w, the shortest way.
  Vec3 way(std::int32_t v, std::int32_t w) const {
    return period.shortest(nodes[w].position - nodes[v].position);
  }
  double length(const CrackEdge& edge) const { return way(edge.a, edge.b).norm(); }
};

CrackNetwork crack_network(const Simulation& simulation);

/// Of all edges, model units.
double total_length(const CrackNetwork& network);

/// Fills in normal, face and kind of the nodes from the mesh, whose vertices they name by their
/// roots, and from the edges.
void describe_nodes(const TriangleMesh& mesh, CrackNetwork& network);

/// What the edges leave behind where they heal.
std::vector<HealedPiece> healed_pieces(const CrackNetwork& network);

}  // namespace craze
