// What varies over the surface, as the simulation wants it.
#pragma once

#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/model/failure/direction_bias.h"
#include "craze/model/failure/healed_cracks.h"
#include "craze/tensor.h"

namespace craze {

/// One value per face of the mesh that the simulation starts with.
/// Faces made later look their values up by TriangleMesh::source_face. Empty: not given.
struct SimulationFields {
  std::vector<Sym3> stress;             ///< σ₀, world axes, force/length
  std::vector<double> onset;            ///< load at which a face starts to be loaded, ≥ 0, or ∞
  std::vector<Sym3> growth;             ///< added to σ per step besides the shrinkage
  std::vector<double> toughness_scale;  ///< factor on τ and strength, ≥ 0; ∞: never fails
  std::vector<double> separation_scale;       ///< factor on ς, ≥ 0 (Figs. 4 and 10)
  std::vector<double> adhesion_scale;         ///< factor on κ, ≥ 0
  std::vector<PreferredDirection> preferred;  ///< which way cracks like to run (Fig. 2)
  std::vector<char> fixed;                    ///< per vertex: 1 where the surface is held
  HealedCracks healed;                        ///< weaknesses left by an earlier cycle
  std::vector<char> pinned;  ///< per vertex: 1 where it must not slide (NearVertex::slide)
};

/// The mean of a factor per source face over the star of v; 1 where none is given.
inline double mean_factor(const TriangleMesh& mesh, const std::vector<double>& per_face,
                          std::int32_t v) {
  if (per_face.empty()) return 1;
  double sum = 0, count = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    sum += per_face[mesh.source_face(h / 3)];
    ++count;
  });
  return count > 0 ? sum / count : 1;
}

}  // namespace craze
