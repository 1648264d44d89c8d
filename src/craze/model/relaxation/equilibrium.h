// The state that relaxation tends to, found directly: K u = f₀ on the neighbourhood of a change.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "craze/base/stop_question.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/relaxation/patch_solver.h"
#include "craze/model/relaxation/tangent_stiffness.h"
#include "craze/model/stress_field.h"
#include "craze/threads.h"

namespace craze {

struct EquilibriumOptions {
  double adhesion = 0;   ///< κ, 1/length²; > 0
  double tolerance = 0;  ///< largest force left on any node, force
  double reach = 0;      ///< changes nearer to each other than this are solved together, length
};

/// Brings a StressField into the equilibrium of Eqs. 3–7 with adhesion: F_n − κ A_n u_n = 0 for all
/// free nodes to within a tolerance, in the tangent plane of the surface: the layer slides over
/// what it sticks to and neither lifts off nor sinks in, so that it is not unloaded by bulges and
/// hollows. σ = σ₀ + B u and F = −Bᵀ A σ are linear in u, so the correction δ solves (K + κ M) δ =
/// F − κ M u, K = Σ A BᵀB: symmetric and, with κ > 0, positive definite. Adhesion screens: the
/// correction for a new crack decays over ℓ = 1/√κ, and is sought where it matters
/// (patch_solver.h). Corrections are single precision, what they act on and the residual double.
class Equilibrium {
 public:
  explicit Equilibrium(const EquilibriumOptions& options)
      : options_(options), stiffness_(options.adhesion) {}

  void set_tolerance(double tolerance) { options_.tolerance = tolerance; }

  /// Lets the forces on v change by this much, in sum over its elements, from now on, before
  /// restore() reports it; at least by the tolerance. Returns what was granted.
  double allow_drift(std::int32_t v, double force);

  /// Forces on v were changed from outside, by this much more at most, in sum over its elements:
  /// restore() brings v into equilibrium too. Returns whether that is more than was allowed.
  bool force_added(std::int32_t v, double force);

  /// Restores equilibrium after the stars of the nodes `changed` did, or anything else at them; all
  /// other nodes must be in equilibrium already. Appends to `moved` the nodes whose forces have
  /// changed by more than was allowed (allow_drift). A tolerance below the rounding of the forces
  /// is not reached: the residual is then what rounding leaves. Changes far apart are solved apart,
  /// in parallel; the result does not depend on threads. Where `stop` says so the state is in step
  /// but not in equilibrium. Ends: a round either halves the largest residual or is one of the few
  /// that need not.
  void restore(StressField& field, const TriangleMesh& mesh,
               const std::vector<std::int32_t>& changed, const Threads& threads,
               std::vector<std::int32_t>& moved, const StopQuestion& stop = {});

  /// Gives back what restore() makes anew: the stiffness and the solvers' storage.
  void release_memory();

  /// Whether every restore() came within its tolerance.
  bool met_tolerance() const { return met_tolerance_; }
  std::int64_t iterations() const { return iterations_; }
  std::int64_t element_updates() const { return element_updates_; }

 private:
  struct Patch {
    std::vector<std::int32_t> seeds;
    PatchAnswer answer;
    // Nodes whose forces changed more than was allowed; seeds of the next round, if there is one.
    std::vector<std::int32_t> moved, open;
    double largest_residual = 0;  // of those, squared
  };

  /// What it takes to work on a patch, wanted while one is worked on.
  struct Workshop {
    PatchSolver solver;
    std::vector<std::int32_t> marks;   // #V, −1 between uses
    std::vector<Vec4d> displacements;  // of the answer's active nodes
    std::vector<std::int32_t> faces;   // around its nodes
  };
  /// Workshops that nobody is in; they are all alike.
  class Workshops {
   public:
    Workshop take(std::int32_t nodes);
    void put_back(Workshop workshop);
    void clear() { free_ = std::vector<Workshop>(); }

   private:
    std::mutex mutex_;
    std::vector<Workshop> free_;
  };

  void cluster(const TriangleMesh& mesh, const std::vector<std::int32_t>& seeds);
  void solve(const LayerState& layer, bool takes_all, const Threads& threads,
             const StopQuestion& stop);
  void apply(StressField& field, const LayerState& layer, const Threads& threads);
  void apply(StressField& field, const LayerState& layer, const PatchAnswer& answer,
             Workshop& workshop);
  void review(const LayerState& layer, std::size_t patch);

  EquilibriumOptions options_;
  TangentStiffness stiffness_;
  std::vector<Patch> patches_;  // storage kept between calls
  std::size_t patch_count_ = 0;
  std::vector<std::int32_t> seed_patch_;  // #V: the patch that a node is a seed of, −1: of none
  Workshops workshops_;
  std::vector<std::int32_t> group_;  // #V: the last group of patches applied together that read it
  std::int32_t groups_ = 0;
  std::vector<std::int32_t> pulled_;  // by force_added(), since restore()
  std::vector<double> drift_;    // #V: how much the forces changed since drift was last allowed
  std::vector<double> allowed_;  // #V: how much they may
  bool met_tolerance_ = true;
  std::int64_t iterations_ = 0;
  std::int64_t element_updates_ = 0;
};

}  // namespace craze
