// Equilibrium around a change: conjugate gradients on a neighbourhood that grows as they need it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/base/simd.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/stress_field.h"
#include "craze/model/tangent_stiffness.h"

namespace craze {

/// The layer as the solver reads it.
struct LayerState {
  const TriangleMesh& mesh;
  const StressField& field;
  const TangentStiffness& stiffness;
  const std::vector<char>& fixed;  ///< nodes that never move; vertices beyond it are free
  double adhesion;                 ///< κ, 1/length²

  bool is_fixed(std::int32_t v) const {
    return v < static_cast<std::int32_t>(fixed.size()) && fixed[v] != 0;
  }
  /// F − κ A u: what pulls at a node, force; its normal part is borne by what lies under the layer.
  Vec3 pull(std::int32_t v) const {
    return field.force(v) - adhesion * field.node_areas()[v] * field.displacement(v);
  }
};

/// Solves (K + κ M) x = F − κ M u near a few nodes, in single precision, by conjugate gradients
/// with the 2x2 diagonal blocks as preconditioner. Each iteration of that method reaches one ring
/// of neighbours further; here a ring is only taken in while the residual on it matters, so that a
/// solve costs what the change needs, whatever the mesh. Storage is kept from solve to solve.
class PatchSolver {
 public:
  /// Solves until no residual is above half the tolerance (force), or as far as single precision
  /// goes: converged() tells. Nodes farther than `radius` from their seed are held and listed in
  /// rim(). `mark` (#V, −1 everywhere) is written for all nodes that are read: several solvers may
  /// run at once on seeds more than two radii and two edges apart.
  void solve(const LayerState& layer, const std::vector<std::int32_t>& seeds, double tolerance,
             double radius, std::vector<std::int32_t>& mark);
  /// Makes `mark` −1 everywhere again.
  void release(std::vector<std::int32_t>& mark) const;

  /// Nodes read, by rings around the seeds; mark[nodes()[i]] is i.
  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  /// How many of them have moved: the first ones.
  std::int32_t active() const { return active_; }
  const std::vector<std::int32_t>& rim() const { return rim_; }
  bool converged() const { return converged_; }
  /// The displacement of nodes()[i], length.
  Vec3 displacement(const LayerState& layer, std::int32_t i) const;
  std::int64_t iterations() const { return iterations_; }
  /// Sum over the iterations of the nodes read.
  std::int64_t node_updates() const { return node_updates_; }

 private:
  void join(const LayerState& layer, std::int32_t v, std::int32_t seed,
            std::vector<std::int32_t>& mark);
  void load_rows(const LayerState& layer, std::vector<std::int32_t>& mark);
  void activate();
  float multiply();

  double scale_ = 1;         // of forces: the tolerance
  double squared_radius_ = 0;
  bool converged_ = false;
  std::int64_t iterations_ = 0, node_updates_ = 0;

  // Of the nodes, [0, active_) may move, [active_, loaded_) is the ring whose residual is watched,
  // and those after are its neighbours.
  std::int32_t active_ = 0, loaded_ = 0;
  std::vector<std::int32_t> nodes_, origin_, rim_;
  std::vector<std::int32_t> row_begin_, columns_;
  std::vector<Vec4f> blocks_;
  // Two numbers a node, and an even number of nodes; zero where a node is not active.
  std::vector<float> x_, r_, z_, p_, q_;
  std::vector<float> inverse_diagonal_, inverse_off_diagonal_;  // of the 2x2 blocks
};

}  // namespace craze
