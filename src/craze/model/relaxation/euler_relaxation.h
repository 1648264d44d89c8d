// [IO06] §4.1, Eqs. 3–7: explicit relaxation of the stress.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/simd.h"
#include "craze/base/stop_question.h"
#include "craze/model/relaxation/active_elements.h"
#include "craze/model/relaxation/relaxation_schedule.h"
#include "craze/model/relaxation/relaxation_steps.h"
#include "craze/model/relaxation/stiffness_bound.h"
#include "craze/model/stress_field.h"
#include "craze/threads.h"

namespace craze {

struct EulerRelaxationOptions {
  double time_step = 0.1;    ///< Δt of Eq. 3
  double adhesion = 0;       ///< κ, 1/length²: F ← F − κ A_n u. 0: the paper
  double rest_force = 0;     ///< nodes whose force is at most this are in equilibrium and not moved
  bool accelerated = false;  ///< the same in fewer steps (relaxation_schedule.h); wants κ = 0
};

/// Moves every node that is not held at once (Jacobi): Δp = Δt F, u += Δp, σ += (∂ε/∂p) Δp, F from
/// the new σ. It is gradient descent on ½ Σ A |σ|² (+ ½ κ Σ A_n |u|²), so that energy never rises
/// while Δt is at most 2 / (largest eigenvalue of K + κ M). Where the bound on that eigenvalue does
/// not say so, each step is taken as the least number of equal ones for which it does: the same
/// flow over the same time. Accelerated, energy never rises for any Δt. Blocks of elements none of
/// whose nodes is moved are skipped.
///
/// Of several steps only F is followed from one to the next, in single precision (the moves come
/// out good to 10⁻⁶). σ and F are then made from the moves in double precision: F is the force of
/// σ, and σ the stress of u, to the last digits.
class EulerRelaxation {
 public:
  EulerRelaxation(const TriangleMesh& mesh, const StressField& field,
                  const EulerRelaxationOptions& options);

  /// Takes in faces and vertices appended since, the faces listed, whose corners changed, and the
  /// nodes listed, whose star did.
  void mesh_changed(const TriangleMesh& mesh, const StressField& field,
                    const std::vector<std::int32_t>& faces, const std::vector<std::int32_t>& nodes);

  /// Takes `steps` steps, or goes as far; stops where nothing moves any more, or `stop` says so.
  /// Forces must be up to date, and are afterwards. The result does not depend on `threads`.
  void run(StressField& field, const TriangleMesh& mesh, std::int64_t steps, const Threads& threads,
           const StopQuestion& stop = {});
  /// Goes on where `stop` ended run(), to the same bytes as without it; nothing to do: returns.
  void resume(StressField& field, const TriangleMesh& mesh, const Threads& threads,
              const StopQuestion& stop);
  bool has_steps_left() const { return steps_left_ > 0; }
  /// The bound on the largest eigenvalue of K + κ M, over mass 1.
  double stiffness() const { return stiffness_.value(); }
  /// Into how many stable steps one is split; 1 when accelerated.
  double parts_of_a_step() const;

  /// As Relaxation::allow_drift; grants all.
  double allow_drift(std::int32_t v, double force);
  /// Appends the nodes whose forces have changed by more than was allowed, in ascending order.
  void drifted(std::vector<std::int32_t>& nodes) const;

  /// Elements updated so far, over all steps.
  std::int64_t element_updates() const { return element_updates_; }
  /// The largest force that moved a node when the last step, or the last few, began; 0 at rest.
  double largest_force() const { return largest_force_; }

 private:
  double step_size() const { return options_.time_step / parts_of_a_step(); }
  void resize(const StressField& field);
  bool steps_are_stable() const { return options_.time_step * scheduled_stiffness_ <= 2; }
  double next_steps(double remaining);
  void move_nodes(const StressField& field, double time_step, const Threads& threads);
  void apply_moves(StressField& field, const TriangleMesh& mesh, const Threads& threads);

  EulerRelaxationOptions options_;
  ElementBlocks blocks_;
  RelaxationSteps steps_;
  StiffnessBound stiffness_;
  std::vector<RelaxationStep> schedule_;
  double scheduled_steps_ = 0, scheduled_step_ = 0, scheduled_stiffness_ = 0;

  ActiveElements active_;
  std::vector<char> held_;                             // #V
  std::vector<Vec4d> moves_;                           // #V, change of u
  std::vector<Vec4d> changes_[ActiveElements::lanes];  // #V, of F; lane 3: the sum of their bounds
  std::vector<char> moving_;                           // per node block
  std::vector<double> block_force_;                    // per node block: largest |F|² that moves
  std::vector<double> drift_, allowed_;                // #V
  std::int64_t element_updates_ = 0;
  double steps_left_ = 0;  // of those asked for, split
  double largest_force_ = 0;
};

}  // namespace craze
