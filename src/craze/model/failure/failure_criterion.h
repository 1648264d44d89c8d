// When a node fails: the paper's toughness on v⁺, or strength and toughness that do not see the
// mesh.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/model/failure/separation_tensor.h"
#include "craze/model/stress_field.h"
#include "craze/parameters.h"
#include "craze/tensor.h"

namespace craze {

/// Whether v is the end of a crack inside the surface: both its open edges are sides of one crack
/// edge.
bool is_crack_tip(const TriangleMesh& mesh, std::int32_t v);

/// The eigenvalue v⁺ that a unit uniaxial tension along the unit vector n̂ would give an interior
/// node: ½ Σ A |n̂·∇λ_v| over its star, the half width over which the node carries that tension;
/// length. v⁺ over it is the tension across the crack plane, whatever the mesh.
double node_width(const TriangleMesh& mesh, std::int32_t v, const Vec3& normal);

/// Mean of n̂ᵀ σ n̂ along the way a crack would take: from v straight through the plane of normal n̂,
/// to every side on which it meets the star, over `length` or up to a crack or border;
/// force/length.
double mean_tension_ahead(const TriangleMesh& mesh, const StressField& field, std::int32_t v,
                          const Vec3& normal, double length);

/// The v⁺ at which a typical intact node fails, force: what a force is small or large against.
double typical_failure_force(const TriangleMesh& mesh, const MaterialParameters& material);
/// The tension under which such a node fails, force/length.
double typical_failure_tension(const TriangleMesh& mesh, const MaterialParameters& material);

/// Turns (v⁺, n̂⁺) of a node into a force threshold. Criterion "force": τ [IO06 §3.4]. Criterion
/// "strength": an intact node fails at v⁺ = strength · w, a crack tip at v⁺ = toughness · √w, with
/// w = node_width(n̂⁺), since the stress near a tip grows as 1/√distance. No intact node fails
/// within the process zone of a tip, where the stress is the tip's; and on the side of a crack or
/// border the tension must reach the strength on average over the process zone, not just at a
/// corner of the crack, where it is high over no length to speak of.
class FailureCriterion {
 public:
  /// process_zone: length.
  FailureCriterion(const MaterialParameters& material, double process_zone);

  double process_zone() const { return process_zone_; }

  /// A lower bound of threshold() that looks no farther than the star of v.
  double least_threshold(const TriangleMesh& mesh, std::int32_t v, const Vec3& normal,
                         double scale) const;
  /// The v⁺ above which v fails by the crack plane of `failure`, its own v⁺ and n̂⁺; ∞ where it
  /// cannot. `scale` multiplies toughness and strength, `least` is the least_threshold(). Where a
  /// tip's process zone keeps v from failing, `shield` becomes that tip, else −1.
  double threshold(const TriangleMesh& mesh, const StressField& field, std::int32_t v,
                   const Eigenpair& failure, double scale, double least,
                   std::int32_t& shield) const;
  /// A crack at `from` made the new tip `to`.
  void tip_advanced(const TriangleMesh& mesh, std::int32_t from, std::int32_t to);
  /// Keeps the list of tips up to date; call for every node whose star changed. Returns whether v
  /// was a tip and is no longer.
  bool node_changed(const TriangleMesh& mesh, std::int32_t v);

 private:
  std::int32_t tip_near(const TriangleMesh& mesh, std::int32_t v) const;

  MaterialParameters material_;
  double process_zone_;
  std::unordered_map<std::int32_t, Vec3> origin_;  // of a tip: where its crack started
  std::vector<char> listed_;                       // #V, in tips_
  std::unordered_map<std::uint64_t, std::vector<std::int32_t>> tips_;  // by cell of the zone's size
};

}  // namespace craze
