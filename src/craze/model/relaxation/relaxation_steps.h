// Several steps of relaxation, in single precision: where they would take the nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/simd.h"
#include "craze/base/stop_question.h"
#include "craze/model/relaxation/active_elements.h"
#include "craze/model/relaxation/element_packs.h"
#include "craze/model/relaxation/relaxation_schedule.h"
#include "craze/model/stress_field.h"
#include "craze/threads.h"

namespace craze {

/// What steps start from and are bound to.
struct RelaxationState {
  const StressField& field;
  const ElementBlocks& blocks;
  const std::vector<char>& held;  ///< #V, nodes that never move
  double adhesion;                ///< κ
  double rest_force;
};

/// Follows the forces alone, F ← F − (K + κ A_n) Δp, from step to step; σ and u are left as they
/// are. Good to about 10⁻⁶ of the forces at the start, for a few hundred steps.
class RelaxationSteps {
 public:
  /// Takes in faces appended since, and those around the nodes listed, whose star changed.
  void update(const TriangleMesh& mesh, const StressField& field,
              const std::vector<std::int32_t>& nodes) {
    packs_.update(mesh, field, nodes);
  }

  /// `moves` (#V) becomes Σ weight · Δp of the steps, `moving` (per node block) where it is not 0.
  /// Returns the number of element blocks updated. Where `stop` says so nothing moves at all.
  std::int64_t take(const RelaxationState& state, const std::vector<RelaxationStep>& steps,
                    std::vector<Vec4d>& moves, std::vector<char>& moving, const Threads& threads,
                    const StopQuestion& stop);

 private:
  void start(const RelaxationState& state, const Threads& threads);
  void move_nodes(const RelaxationState& state, const RelaxationStep& step, bool first,
                  const Threads& threads);
  void change_forces(int faces, const Threads& threads);

  ElementPacks packs_;
  ActiveElements active_;
  std::vector<Vec4f> forces_;                          // #V, F − κ A_n u
  std::vector<Vec4f> steps_;                           // #V, Δp
  std::vector<Vec4f> sums_;                            // #V, Σ weight · Δp
  std::vector<float> adhesion_;                        // #V, κ A_n
  std::vector<Vec4f> changes_[ActiveElements::lanes];  // #V
  std::vector<char> moving_;                           // per node block, in the last step
  std::vector<char> moved_;                            // per node block, in any step
};

}  // namespace craze
