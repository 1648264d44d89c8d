// [IO06] §3.1, steps 2 and 3c: which node fails next, by which plane, and under what load.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/model/cutting/crack_insertion.h"
#include "craze/model/failure/failure.h"
#include "craze/model/failure/failure_criterion.h"
#include "craze/model/failure/failure_queue.h"
#include "craze/model/failure/foreseen_failures.h"
#include "craze/model/failure/stress_ahead.h"
#include "craze/model/relaxation/loading.h"
#include "craze/model/relaxation/relaxation.h"
#include "craze/model/simulation_fields.h"
#include "craze/model/stress_field.h"
#include "craze/parameters.h"
#include "craze/tensor.h"
#include "craze/threads.h"

namespace craze {

/// The priority queue of the nodes that can fail, kept by upper bounds. A node far from failing
/// enters with what its v⁺ could become at most, and is not looked at again until the forces on it
/// have changed by as much; only what comes to the top is evaluated exactly. So a crack costs a few
/// evaluations of ς, not one for each node whose stress it changes.
class FailureWatch {
 public:
  struct Scene {
    const TriangleMesh& mesh;
    const StressField& field;
    const SimulationFields& fields;
    const Loading& loading;
    Relaxation& relaxation;
  };

  /// Wants resolved parameters (screening.h).
  explicit FailureWatch(const SimulationParameters& parameters);

  /// Evaluates these nodes, in any order and with repeats (they come back sorted).
  void look_at(const Scene& scene, std::vector<std::int32_t>& nodes, const Threads& threads);

  /// Before the cracks of a step: works out in parallel what next() and crack_plane() will say of
  /// the nodes with at least that measure, as many of the first as the last step asked for and some
  /// more. They say the same without it.
  void foresee(const Scene& scene, double least_measure, const Threads& threads);
  /// After them.
  void forget_foreseen() { foreseen_.clear(); }

  /// The node with the greatest measure, evaluated exactly; −1 where none can fail.
  std::int32_t next(const Scene& scene);
  double measure(std::int32_t v) const { return queue_.measure(v); }
  /// Eq. 8's residual of a node at the load that was reached, force; zero but at live tips.
  Sym3 residual(std::int32_t v) const;
  /// The plane by which v, that next() found, opens: n̂⁺ of ς, or, for a tip that looks ahead, of
  /// the mean stress there (stress_ahead.h) in the place of ς.
  CrackPlane crack_plane(const Scene& scene, std::int32_t v);

  /// residual() goes by other numbers from now on, `now` the new ones. Nothing else may be asked.
  void renumber(const std::vector<std::int32_t>& now);
  /// Gives back the memory that was kept for more nodes.
  void shrink_to_fit();

  /// Whether any node would fail under some load, however high; asked where next() finds none.
  bool can_any_fail() const;

  /// A node that is not to be found by next() until it is taken back.
  void set_aside(std::int32_t v) { queue_.remove(v); }
  void take_back(std::int32_t v) { queue_.set(v, failing_[v].measure); }

  /// v failed but no segment was admissible: it is left alone until the plane turns.
  void could_not_open(std::int32_t v);
  /// v failed and opened on a plane of that normal. Appends the nodes to look at again, besides
  /// those that relax() names.
  void opened(const Scene& scene, std::int32_t v, const Vec3& normal, const CrackOutcome& outcome,
              std::vector<std::int32_t>& changed);

 private:
  /// The weakness that healed cracks leave at a node, and where it was when that was found.
  struct Scar {
    Vec3 position = Vec3::Zero();
    Mat3 weakness = Mat3::Zero();
  };

  Sym3 biased(const Scene& scene, std::int32_t v, const Sym3& separation) const;
  Failure evaluate(const Scene& scene, std::int32_t v, bool exact);
  Failure failure_of(const Scene& scene, std::int32_t v, const Sym3& separation, double scale,
                     bool exact);
  CrackPlane plane_of(const Scene& scene, std::int32_t v, const Vec3& normal,
                      StressAhead& stress_ahead);
  /// The factor on strength and toughness that the faces around v have, kept until its star
  /// changes.
  double resistance(const Scene& scene, std::int32_t v);
  const Mat3& weakness(const Scene& scene, std::int32_t v);
  void enter(const Scene& scene, std::int32_t v);
  /// Whether the queue has v by its exact measure.
  bool is_exact(std::int32_t v) const {
    return failing_[v].exact && queue_.measure(v) == failing_[v].measure;
  }

  double alpha_, bias_, lookahead_;
  double influence_ = -1;  // of a crack on what is foreseen, length; −1: not known
  FailureCriterion criterion_;
  StressAhead stress_ahead_;
  FailureQueue queue_;  // by measure, or its upper bound
  ForeseenFailures foreseen_;
  std::size_t asked_ = 0;  // nodes that next() has looked at since foresee()

  std::vector<Failure> failing_;                      // #V
  std::vector<double> resistance_;                    // #V, −1: not known
  std::vector<Scar> scars_;                           // #V where cracks have healed
  std::unordered_map<std::int32_t, Sym3> residuals_;  // Eq. 8, of live tips
  std::unordered_map<std::int32_t, Vec3> arrested_;   // planes on which a node could not open
  // Nodes that would fail but for the process zone of a tip.
  std::unordered_map<std::int32_t, std::vector<std::int32_t>> shielded_;
};

}  // namespace craze
