// [IO06] §4.1, Eqs. 3–7: explicit relaxation of the stress, one Euler step at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/simd.h"
#include "craze/model/element_blocks.h"
#include "craze/model/stress_field.h"

namespace craze {

struct EulerRelaxationOptions {
  double time_step = 0.1;  ///< Δt of Eq. 3
  double adhesion = 0;     ///< κ, 1/length²: F ← F − κ A_n u. 0: the paper
  double rest_force = 0;   ///< nodes whose force is at most this are in equilibrium and not moved
};

/// Moves every node at once (Jacobi): Δp = Δt F, u += Δp, σ += (∂ε/∂p) Δp, F from the new σ. It is
/// gradient descent on ½ Σ A |σ|² (+ ½ κ Σ A_n |u|²), so that energy never rises while Δt is below
/// 2 / (largest eigenvalue of K). Blocks of elements none of whose nodes is moved are skipped.
class EulerRelaxation {
 public:
  EulerRelaxation(const TriangleMesh& mesh, const EulerRelaxationOptions& options);

  /// Nodes that never move: the paper's fixed boundary. Vertices beyond the vector are free.
  std::vector<char> fixed;

  /// Takes `steps` steps. Forces must be up to date, and are afterwards. `blocks` must know all the
  /// faces of the mesh. The result does not depend on `threads`.
  void run(StressField& field, const TriangleMesh& mesh, const ElementBlocks& blocks,
           std::int64_t steps, int threads);

  /// Node blocks whose forces or stresses changed since clear_changed().
  const std::vector<char>& changed_blocks() const { return changed_; }
  void clear_changed() { changed_.assign(changed_.size(), 0); }
  /// Elements updated so far, over all steps.
  std::int64_t element_updates() const { return element_updates_; }
  /// Largest force that moved a node in the last step; 0 at rest.
  double largest_force() const { return largest_force_; }

 private:
  void move_nodes(StressField& field, const ElementBlocks& blocks, int threads);
  void update_stress(StressField& field, const TriangleMesh& mesh, int threads);
  void collect_forces(StressField& field, int threads);

  // Force changes are summed in a fixed number of lanes, each by one thread in order, and the lanes
  // in order: the same sums on any number of threads.
  static constexpr int lanes = 4;
  std::size_t lane_begin(std::size_t lane) const { return active_.size() * lane / lanes; }

  EulerRelaxationOptions options_;
  std::vector<Vec4d> moves_;                // #V, Δp of this step
  std::vector<Vec4d> force_change_[lanes];  // #V
  std::vector<double> block_force_;         // per node block: largest |F| that moves a node
  std::vector<unsigned char> touched_;      // per node block, a bit per lane: changes to collect
  std::vector<char> changed_;               // per node block
  std::vector<std::int32_t> active_;        // element blocks of this step
  std::int64_t element_updates_ = 0;
  double largest_force_ = 0;
};

}  // namespace craze
