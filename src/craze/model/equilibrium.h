// The state that relaxation tends to, found directly: K u = f₀ on the neighbourhood of a change.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/simd.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/stress_field.h"

namespace craze {

struct EquilibriumOptions {
  double adhesion = 0;      ///< κ, 1/length²; > 0
  double tolerance = 0;     ///< largest force left on any node, force
  double noticeable = 0;    ///< change of the forces on a node at which it is reported, force
  double radius = 0;        ///< of the first neighbourhood solved around a change, length
  double longest_edge = 0;  ///< of the mesh, length: keeps patches solved in parallel apart
};

/// Brings a StressField into the equilibrium of Eqs. 3–7 with adhesion: F_n − κ A_n u_n = 0 for all
/// free nodes to within a tolerance, in the tangent plane of the surface: the layer slides over
/// what it sticks to and neither lifts off nor sinks in, so that it is not unloaded by bulges and
/// hollows. σ = σ₀ + B u and F = −Bᵀ A σ are linear in u, so the correction δ solves (K + κ M) δ =
/// F − κ M u, K = Σ A BᵀB: symmetric and, with κ > 0, positive definite. Adhesion screens: the
/// correction for a new crack decays over ℓ = 1/√κ. It is sought by conjugate gradients on the
/// nodes near the change alone, and the neighbourhood grows while more than the tolerance leaks out
/// of it. Cost per change: O((radius / h)²) per iteration, whatever the mesh.
class Equilibrium {
 public:
  explicit Equilibrium(const EquilibriumOptions& options) : options_(options) {}

  /// Nodes that never move. Vertices beyond the vector are free.
  std::vector<char> fixed;

  void set_tolerance(double tolerance, double noticeable) {
    options_.tolerance = tolerance;
    options_.noticeable = noticeable;
  }

  /// Restores equilibrium after something changed at the nodes `seeds`; all other nodes must be in
  /// equilibrium already. Appends to `moved` the nodes whose separation tensor may have changed by
  /// more than `noticeable` since they were last in it. Seeds far apart are solved apart, in
  /// parallel; the result does not depend on threads.
  void restore(StressField& field, const TriangleMesh& mesh, const std::vector<std::int32_t>& seeds,
               int threads, std::vector<std::int32_t>& moved);

  /// The tangential part of F − κ A u: what still pulls at a node; 0 where it is fixed.
  Vec3 residual(const StressField& field, std::int32_t v) const;

  std::int64_t iterations() const { return iterations_; }
  std::int64_t element_updates() const { return element_updates_; }

 private:
  struct Patch {
    std::vector<std::int32_t> seeds;
    std::vector<std::int32_t> nodes;                   // global index of each local node
    std::vector<std::int32_t> origin;                  // the seed whose wave reached it
    std::vector<std::int32_t> faces;                   // global
    std::vector<std::array<std::int32_t, 3>> corners;  // local node, or nodes.size(): held
    std::vector<Element> elements;                     // copies, for streaming
    std::vector<Vec4d> x, r, p, q;                     // nodes.size() + 1 each
    std::vector<Vec4d> normals;                        // nodes.size()
    std::vector<double> inverse_diagonal, mass;
    std::int64_t iterations = 0;
  };

  void cluster_seeds(const TriangleMesh& mesh, const std::vector<std::int32_t>& seeds,
                     double reach);
  void grow(const TriangleMesh& mesh, Patch& patch, double radius);
  void solve(const StressField& field, Patch& patch) const;
  void apply(StressField& field, const TriangleMesh& mesh, const Patch& patch);
  bool is_fixed(std::int32_t v) const {
    return v < static_cast<std::int32_t>(fixed.size()) && fixed[v] != 0;
  }

  EquilibriumOptions options_;
  std::vector<Patch> patches_;  // storage kept between calls
  std::size_t patch_count_ = 0;
  std::vector<std::int32_t> node_mark_;  // #V: local index in its patch, −1: in none
  std::vector<char> face_mark_;          // #F: in a patch
  std::vector<double> drift_;            // #V: force changed since last reported
  std::int64_t iterations_ = 0;
  std::int64_t element_updates_ = 0;
};

}  // namespace craze
