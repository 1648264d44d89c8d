// Equilibrium around a change: conjugate gradients on a neighbourhood that grows as they need it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/base/simd.h"
#include "craze/base/stop_question.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/relaxation/tangent_stiffness.h"
#include "craze/model/stress_field.h"

namespace craze {

/// The layer as the solver reads it.
struct LayerState {
  const TriangleMesh& mesh;
  const StressField& field;
  const TangentStiffness& stiffness;
  double adhesion;   ///< κ, 1/length²
  double tolerance;  ///< largest residual that may stay, force

  /// Asks for what pull() and the residual read, some time before.
  void prefetch(std::int32_t v) const {
    __builtin_prefetch(&field.forces()[v]);
    __builtin_prefetch(&field.displacements()[v]);
    __builtin_prefetch(&field.normals()[v]);
    __builtin_prefetch(&field.node_areas()[v]);
  }
  /// F − κ A u: what pulls at a node, force; its normal part is borne by what lies under the layer.
  Vec3 pull(std::int32_t v) const {
    return field.force(v) - adhesion * field.node_areas()[v] * field.displacement(v);
  }
};

/// What a solve has found.
struct PatchAnswer {
  std::vector<std::int32_t> nodes;  ///< that were read, by rings around the seeds
  std::int32_t active = 0;          ///< how many of them have moved: the first ones
  std::vector<std::int32_t> held;   ///< fixed nodes next to those
  std::vector<float> x;             ///< two numbers a node, times `scale`
  double scale = 1;                 ///< of forces: the tolerance or more
  std::int64_t iterations = 0;
  std::int64_t node_updates = 0;  ///< sum over the iterations of the nodes read

  /// The displacement of nodes[i], length.
  Vec3 displacement(const LayerState& layer, std::int32_t i) const;
};

/// Solves (K + κ M) x = F − κ M u near a few nodes, in single precision, by conjugate gradients
/// with the 2x2 diagonal blocks as preconditioner. Each iteration of that method reaches one ring
/// of neighbours further; here a ring is only taken in while the residual on it matters, so that a
/// solve costs what the change needs, whatever the mesh. Storage is kept from solve to solve.
class PatchSolver {
 public:
  /// Solves until no residual is above half the tolerance, or as far as single precision goes; only
  /// the forces themselves tell what is left. The problem is linear, so changes in different places
  /// may be solved apart and their answers added, however near they are, as long as each residual
  /// is in one of them: `seed_patch` (#V) says which patch a node is a seed of (−1: none). The
  /// residual of another's seed counts as zero; that of a node that is nobody's is taken up too
  /// where the patch `takes_all`, which patches that overlap must not do again and again. `mark`
  /// (#V, −1 everywhere, and again at the end) is scratch. Where `stop` says so the answer is as
  /// far as it got, which is nearer to the solution than none.
  void solve(const LayerState& layer, const std::vector<std::int32_t>& seeds, std::int32_t patch,
             bool takes_all, const std::vector<std::int32_t>& seed_patch,
             std::vector<std::int32_t>& mark, const StopQuestion& stop = {});

  /// Of the last solve, to read or to swap for another whose storage may be used.
  const PatchAnswer& answer() const { return answer_; }
  PatchAnswer& answer() { return answer_; }

 private:
  struct Task {
    const LayerState& layer;
    std::int32_t patch;
    bool takes_all;
    const std::vector<std::int32_t>& seed_patch;
    std::vector<std::int32_t>& mark;  // of a node read: its index in answer_.nodes
  };

  void clear();
  void join(const Task& task, std::int32_t v);
  void read_residuals(const Task& task);
  void make_room(std::size_t rows);
  void load_rows(const Task& task);
  void activate();

  PatchAnswer answer_;
  // Of its nodes, [0, active) may move, [active, loaded_) is the ring whose residual is watched,
  // and those after are its neighbours.
  std::int32_t loaded_ = 0;
  std::int32_t residuals_ = 0;  // nodes whose residual was read
  std::vector<std::int32_t> row_begin_, columns_;
  std::vector<Vec4f> blocks_;  // an even number in each row
  // Like answer_.x: two numbers a node, and a multiple of four nodes; zero where it is not active.
  std::vector<float> r_, z_, p_, q_;
  std::vector<float> inverse_diagonal_, inverse_off_diagonal_;  // of the 2x2 blocks
};

}  // namespace craze
