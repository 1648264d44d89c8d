// [IO06] §3.1: the main loop.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/cracked_sheet.h"
#include "craze/model/cutting/crack_insertion.h"
#include "craze/model/failure/failure_watch.h"
#include "craze/model/relaxation/loading.h"
#include "craze/model/relaxation/relaxation.h"
#include "craze/model/simulation_fields.h"
#include "craze/model/stress_field.h"
#include "craze/opened_piece.h"
#include "craze/parameters.h"

namespace craze {

enum class StopReason {
  equilibrium,  ///< nothing moves and nothing can fail any more
  max_load,
  max_cracks,
  shattered,  ///< there are as many pieces of crack as the mesh can tell apart
  idle,       ///< loading goes on, but nothing has failed for very long
  cancelled,
};
const char* to_string(StopReason reason);

/// Wall-clock seconds spent in each part of the loop.
struct PhaseTimes {
  double relax = 0, separation = 0, crack = 0;
};

/// One straight piece of crack, as it was opened. What has the label i (TriangleMesh::crack_of) is
/// a part of the i-th.
struct OpenedSegment {
  CrackSegment geometry;
  double time;         ///< Simulation::time() when it opened
  std::int32_t event;  ///< the crack event that made it, counted from 0
};

/// Cracks a mesh. Nodes do not move: the result is the cut mesh, its stress, and when and where
/// each crack opened. Can be moved: it keeps no pointer into itself. The same mesh, fields and
/// parameters give the same bytes on any number of threads.
class Simulation {
 public:
  /// Step 1 of the pseudo-code. Throws Error(request) where a field's size is wrong, a
  /// parameter or a stress is out of the range that can be computed with, or the work would take
  /// hours between two cracks; and Cancelled.
  Simulation(TriangleMesh mesh, SimulationFields fields, const SimulationParameters& parameters,
             const Context& context);

  /// Steps 2 and 3, until nothing can fail, a limit is reached or the context cancels; called again
  /// it goes on. The state is consistent whenever it returns. Throws Error(request) where it is not
  /// finite any more.
  ///
  /// It ends: a pass opens at least one segment, of which there are at most most_segments_; or
  /// none, and stops as idle after a number of updates; of passes that update nothing there are no
  /// more than nodes, each of which makes a node wait until its star or its stress has changed, and
  /// steps of an OnsetLoading, which are bounded.
  StopReason run(const Context& context, const OnOpened& on_opened = {});

  /// Gives the mesh and all that is known of it other numbers, those that it started with. After it
  /// the simulation cannot run on.
  void renumber(const Numbering& numbering);

  const TriangleMesh& mesh() const { return sheet_.mesh(); }
  /// σ, F and u at load 1: load_on_field() times these are the state that was reached.
  const StressField& field() const { return sheet_.field(); }
  /// ς of a node without the residual of Eq. 8, at load 1; force.
  Sym3 separation(std::int32_t v) const;
  /// Per face that the simulation started with: the factor on its toughness, ∞ where no crack runs.
  const std::vector<double>& toughness_scale() const { return fields_.toughness_scale; }
  /// Eq. 8's residual of a node, force; zero but at tips that are about to run on by it.
  Sym3 residual(std::int32_t v) const { return watch_.residual(v); }
  /// The load factor s from where all places start (quasistatic), 1 before a load was sought; 1
  /// (euler, or where places start apart: then the field is the true one).
  double load_on_field() const { return loading_->load() > 0 ? loading_->load() : 1; }
  /// The accumulated virtual displacement u of a node at the load that was reached.
  Vec3 displacement(std::int32_t v) const { return load_on_field() * field().displacement(v); }
  const std::vector<OpenedSegment>& opened() const { return opened_; }
  /// The time at which each crack label (TriangleMesh::crack_of) opened.
  std::vector<double> crack_times() const;

  /// Load factor s (quasistatic), counted from 0 whenever places start; mean tension applied so far
  /// over the initial one (euler).
  double load() const { return loading_->reported_load(); }
  /// What cracks are dated with: s (quasistatic), Δt times the relaxation steps taken (euler).
  double time() const { return loading_->time(); }
  /// Whether the stress was always as near to equilibrium as evolution.residual asks for.
  bool met_tolerance() const { return relaxation_->met_tolerance(); }
  std::int64_t events() const { return events_; }
  std::int64_t segments() const { return static_cast<std::int64_t>(opened_.size()); }
  std::int64_t element_updates() const { return relaxation_->element_updates(); }
  const PhaseTimes& times() const { return times_; }

 private:
  double idle_work() const;
  /// Whether it was not stopped on the way; goes on where it was.
  bool measure_all_nodes(const Context& context);
  bool can_continue(const Context& context);
  bool fails_now(std::int32_t v) const;
  FailureWatch::Scene scene() { return {mesh(), field(), fields_, *loading_, *relaxation_}; }
  void crack_mesh(const Threads& threads);
  bool crack_at(std::int32_t v);
  void tell(const OnOpened& on_opened, std::size_t first) const;
  void run_on(const Vec3& start, const Vec3& normal, const CrackRules& rules);
  void evolve(const Context& context);
  void check_state() const;
  void update_failure_criteria(const Context& context);

  SimulationParameters parameters_;
  SimulationFields fields_;
  CrackedSheet sheet_;
  std::unique_ptr<Loading> loading_;
  std::unique_ptr<Relaxation> relaxation_;
  FailureWatch watch_;
  CrackOutcome outcome_, step_;

  std::vector<OpenedSegment> opened_;
  std::vector<std::int32_t> changed_;  // nodes to be evaluated again

  std::int32_t unmeasured_;  // last nodes of the mesh whose failure was never looked at
  std::int64_t most_segments_;
  bool interrupted_ = false;  // while relaxing
  double idle_growth_ = 0;    // elements that grew since the last crack
  std::int64_t updates_at_crack_ = 0;
  std::int64_t events_ = 0;
  StopReason stop_ = StopReason::equilibrium;
  PhaseTimes times_;
};

}  // namespace craze
