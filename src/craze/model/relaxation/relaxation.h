// Step 3b.i of the main loop: how the stress gives way between two cracks. One class per engine.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "craze/base/stop_question.h"
#include "craze/model/cutting/crack_insertion.h"
#include "craze/model/stress_field.h"
#include "craze/parameters.h"
#include "craze/threads.h"

namespace craze {

/// Restores the stress field after cracks, at load 1: what the load is, loading.h says. Held nodes
/// (StressField::is_held) never move.
class Relaxation {
 public:
  virtual ~Relaxation() = default;
  Relaxation() = default;
  Relaxation(const Relaxation&) = delete;
  Relaxation& operator=(const Relaxation&) = delete;

  /// Takes note of a crack; nothing is relaxed yet.
  virtual void mesh_changed(const TriangleMesh& mesh, const CrackOutcome& outcome) = 0;
  /// Brings the field up to the next moment at which cracks are looked for, under the load given.
  /// Appends the nodes whose separation tensor may have changed, in any order, with repeats. Where
  /// `stop` says so it leaves off; the next call goes on.
  virtual void relax(StressField& field, const TriangleMesh& mesh, double load,
                     const Threads& threads, const StopQuestion& stop,
                     std::vector<std::int32_t>& changed) = 0;
  /// Says that the forces on v may change by this much, in sum over its elements, before relax()
  /// has to name it. Returns what will be granted, from now on: 0 where every change is named.
  virtual double allow_drift(std::int32_t v, double force) = 0;
  /// Says that the forces on v were changed by this much more, at most, in sum over its elements.
  /// Returns whether that is more than is granted: then v has to be looked at again.
  virtual bool force_added(std::int32_t v, double force) = 0;
  /// Gives back memory that only relax() needs, which makes it anew.
  virtual void release_memory() {}

  /// Element updates of a relax() in which nothing is at rest; 0 where they are bounded anyway.
  virtual double work_of_a_round() const { return 0; }

  /// Whether relax() would change nothing that matters any more, or not within hours.
  virtual bool at_rest() const = 0;
  /// Whether relax() always came as near to equilibrium as was asked for.
  virtual bool met_tolerance() const { return true; }
  /// The most nodes that are cracked in one step.
  virtual std::int64_t most_cracks_at_once() const = 0;
  /// How far a failing node's crack runs on before relax(), length; 0: to the next node only.
  virtual double stride() const { return 0; }
  /// How far apart two failing nodes must be to be cracked in one step; ∞: one at a time.
  virtual double independence_distance() const = 0;
  virtual std::int64_t element_updates() const = 0;
};

/// How the field relaxes: as named, but as with "euler" where "quasistatic" has no adhesion.
/// Without it a free sheet's only equilibrium is zero stress; cracks come from the flow towards it,
/// which the paper's scheme follows. Where "quasistatic" is named the flow is the same, in fewer
/// steps.
Engine running_engine(const SimulationParameters& parameters);

/// The relaxation of running_engine().
std::unique_ptr<Relaxation> make_relaxation(const TriangleMesh& mesh, const StressField& field,
                                            const SimulationParameters& parameters);

/// The limit on β's singular values that the engine needs, 1/length (basis_matrix.h).
double engine_singular_value_cap(const TriangleMesh& mesh, Engine engine);

}  // namespace craze
