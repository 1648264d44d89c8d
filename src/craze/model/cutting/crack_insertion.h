// [IO06] §4.2, Fig. 5: opening a crack through a node, by local remeshing.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/model/cracked_sheet.h"
#include "craze/parameters.h"
#include "craze/tensor.h"

namespace craze {

struct CrackRules {
  double snap_angle;  ///< θ₁, radians
  double back_angle;  ///< θ₂, radians: a crack this close to an open edge at its node is not made
  NearVertex near_vertex = NearVertex::snap;
};

/// One new crack edge, from the failing node to the far end.
struct CrackSegment {
  std::int32_t from_root, to_root;  ///< TriangleMesh::root of the ends
  std::int32_t source_face;         ///< an input triangle that holds it
};

/// What opening a crack at a node changed.
struct CrackOutcome {
  std::vector<CrackSegment> segments;       ///< in the order of their labels
  std::vector<std::int32_t> tips;           ///< far ends that are new crack tips
  std::vector<std::int32_t> changed_faces;  ///< old faces whose corners changed
  std::vector<std::int32_t> changed_nodes;  ///< nodes whose star changed, copies included, sorted

  bool empty() const { return segments.empty(); }
  void clear();
  /// Takes in what happened after it, at a tip of its own.
  void append(const CrackOutcome& later, std::int32_t at_tip);
};

/// Opens the plane through node v with normal n̂ in v's star: on each side that the plane meets, one
/// segment from v to the opposite edge. The opposite edge is split there, with both its faces, or
/// within θ₁ of an edge the segment follows that edge, the edge's far vertex having slid onto the
/// plane where the rules say so and it can; within θ₂ of an open edge at v it is dropped. On a bent
/// star that the plane meets more than twice, the two sides that halve the star best are taken.
/// New crack edges are labelled first_label, first_label + 1, … Without any admissible segment
/// nothing is touched and the outcome is empty.
void open_crack(CrackedSheet& sheet, std::int32_t v, const Vec3& normal, const CrackRules& rules,
                std::int32_t first_label, CrackOutcome& outcome);

}  // namespace craze
