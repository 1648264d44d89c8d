// How the load on the layer grows, and what cracks are dated with. One class per engine.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "craze/model/stress_field.h"
#include "craze/parameters.h"

namespace craze {

/// Told of a node whose forces were changed, in sum over its elements by this much more, at most.
using OnAddedForce = std::function<void(std::int32_t node, double force)>;

/// The stored stress field is the one at load 1; the true one is load() times it.
class Loading {
 public:
  virtual ~Loading() = default;
  Loading() = default;
  Loading(const Loading&) = delete;
  Loading& operator=(const Loading&) = delete;

  /// Called before each relaxation: adds to the field what advance() has brought under load by
  /// itself. Nothing where the load is a factor on all of it, or grow() adds it.
  virtual void bring_up(StressField&, const TriangleMesh&, const OnAddedForce&) {}
  /// Called after each relaxation: adds what grows per step to the field, and keeps the time.
  /// Returns whether the field has changed, everywhere then.
  virtual bool grow(StressField& field, const TriangleMesh& mesh) = 0;
  /// Asked where no node fails at the present load and the next would at `needed` (∞: none ever
  /// does); `at_rest`: relaxation moves nothing any more. Returns whether to go on, having raised
  /// the load if that is this engine's way.
  virtual bool advance(double needed, bool at_rest) = 0;

  /// Factor on the stored stress.
  virtual double load() const = 0;
  /// Load up to which failures count as happening now, where they are too far apart to interact.
  virtual double load_of_step() const { return load(); }
  /// Factor up to which the load can still grow: nodes that fail below it stay in the queue.
  virtual double highest_load() const = 0;
  /// What a crack opening now is dated with: simulated time (euler), the load factor s
  /// (quasistatic).
  virtual double time() const = 0;
  /// Mean tension over the initial one, for the report.
  virtual double reported_load() const = 0;
  /// As many times as grow() is called until the highest load is reached, at the most; 1 where the
  /// load jumps there, or nothing grows.
  virtual double steps() const { return 1; }
  /// Whether advance() said no because the limit on the load was reached.
  virtual bool reached_max_load() const = 0;
};

/// What a Loading starts from.
struct InitialLoad {
  double tension = 0;         ///< area mean of tr σ₀ / 2, force/length
  std::vector<Sym3> growth;   ///< per input face, added per step; or empty
  double growth_tension = 0;  ///< area mean of √(½ Σ g²) of growth: of c I in a face's plane, c
  std::vector<double> onset;  ///< per input face, the load at which it starts; empty: 0
  std::vector<Sym3> stress;   ///< per input face, σ₀ where places start apart; else empty
  double failure_load = 1;    ///< the load under which a typical place fails
};

/// The loading of running_engine().
std::unique_ptr<Loading> make_loading(const SimulationParameters& parameters, InitialLoad initial);

}  // namespace craze
