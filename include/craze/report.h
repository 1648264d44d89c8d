// What a run did.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "craze/recipe.h"
#include "craze/repair.h"

namespace craze {

struct MeshCounts {
  std::int64_t vertices = 0, triangles = 0;
};

inline MeshCounts count_mesh(const SurfaceMesh& mesh) {
  return {static_cast<std::int64_t>(mesh.positions.size()),
          static_cast<std::int64_t>(mesh.triangles.size())};
}

struct CrackCounts {
  std::int64_t events = 0;     ///< nodes that failed
  std::int64_t segments = 0;   ///< mesh edges opened
  double length = 0;           ///< of all segments, model units
  std::int64_t fragments = 0;  ///< connected parts of the cut mesh
};

/// How the cracks were carried from the simulation's mesh onto the input's own triangles; all 0
/// where the input cracked itself or mesh.output is "simulation".
struct CarriedCounts {
  std::int64_t split_triangles = 0;  ///< of the input, by cracks that pass through them
  std::int64_t added_triangles = 0;  ///< goes with the length of the cracks
  std::int64_t rerouted_pieces = 0;  ///< that no plane led straight along
  std::int64_t lost_pieces = 0;      ///< given up: gaps between parts, folds back onto themselves
  double lost_length = 0;            ///< of those, model units
};

/// Wall-clock seconds. The parts do not sum to the total: a run does other things too.
struct RunTimes {
  double total = 0, load = 0, prepare = 0, relax = 0, separation = 0, crack = 0, carry = 0,
         write = 0;
};

/// What is known of a run, but for the statistics of its pattern.
struct Report {
  Recipe recipe;
  int threads = 1;
  MeshCounts input;       ///< as the file holds it
  MeshCounts simulation;  ///< before the first crack
  MeshCounts output;      ///< as it is written or handed over
  RepairReport repair;
  CrackCounts cracks;
  CarriedCounts carried;
  RunTimes time;
  double load = 0;  ///< load factor at the end
  std::string stop_reason;
  std::vector<std::string> warnings;  ///< what could not be done as asked
};

}  // namespace craze
