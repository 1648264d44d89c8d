// Step 3b of the main loop: how the stress changes between two cracks. One class per engine.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "craze/model/cutting/crack_insertion.h"
#include "craze/model/parameters.h"
#include "craze/model/stress_field.h"

namespace craze {

/// An engine. The stored stress field is the one at load 1; the true one is load() times it.
class Evolution {
 public:
  virtual ~Evolution() = default;
  Evolution() = default;
  Evolution(const Evolution&) = delete;
  Evolution& operator=(const Evolution&) = delete;

  /// Nodes that are held; may be shorter than #V, the rest is free.
  virtual std::vector<char>& fixed() = 0;
  /// Takes note of a crack; nothing is relaxed yet.
  virtual void mesh_changed(const TriangleMesh& mesh, const CrackOutcome& outcome) = 0;
  /// Brings the field up to the next moment at which cracks are looked for. Appends the nodes whose
  /// separation tensor may have changed, in any order, with repeats.
  virtual void evolve(StressField& field, const TriangleMesh& mesh, int threads,
                      std::vector<std::int32_t>& changed) = 0;
  /// Says that the forces on v may change by this much, in sum over its elements, before evolve()
  /// has to name it. Returns what will be granted, from now on: 0 where every change is named.
  virtual double allow_drift(std::int32_t v, double force) = 0;
  /// Asked where no node fails at the present load and the next would at `needed` (∞: none ever
  /// does). Returns whether to go on, having raised the load if that is this engine's way.
  virtual bool advance(double needed) = 0;

  /// Gives back memory that only evolve() needs, which makes it anew.
  virtual void release_memory() {}

  /// Factor on the stored stress.
  virtual double load() const = 0;
  /// Load up to which failures count as happening now, where they are too far apart to interact.
  virtual double load_of_step() const { return load(); }
  /// Factor up to which the load can still grow: nodes that fail below it stay in the queue.
  virtual double highest_load() const = 0;
  /// What a crack opening now is dated with: simulated time (euler), the load factor s
  /// (quasistatic).
  virtual double time() const = 0;
  /// How far a failing node's crack runs on before evolve(), length; 0: to the next node only.
  virtual double stride() const { return 0; }
  /// How far apart two failing nodes must be to be cracked in one step; ∞: one at a time.
  virtual double independence_distance() const = 0;
  virtual std::int64_t element_updates() const = 0;
  /// Mean tension over the initial one, for the report.
  virtual double reported_load() const = 0;
  /// Whether advance() said no because the limit on the load was reached.
  virtual bool reached_max_load() const = 0;
  /// Whether evolve() always came as near to equilibrium as was asked for.
  virtual bool met_tolerance() const { return true; }
};

struct EvolutionInputs {
  double initial_tension = 0;                 ///< area mean of tr σ₀ / 2, force/length
  const std::vector<Sym3>* growth = nullptr;  ///< per input face, added per step, or empty
  std::vector<char> fixed;
};

/// How the field evolves: as named, but as with "euler" where "quasistatic" has no adhesion.
/// Without it a free sheet's only equilibrium is zero stress; cracks come from the flow towards it,
/// which the paper's scheme follows. Where "quasistatic" is named the flow is the same, in fewer
/// steps.
Engine running_engine(const SimulationParameters& parameters);

/// The engine of running_engine().
std::unique_ptr<Evolution> make_evolution(const TriangleMesh& mesh, const StressField& field,
                                          const SimulationParameters& parameters,
                                          const EvolutionInputs& inputs);

/// The limit on β's singular values that the engine needs, 1/length (basis_matrix.h).
double engine_singular_value_cap(const TriangleMesh& mesh, Engine engine);

}  // namespace craze
