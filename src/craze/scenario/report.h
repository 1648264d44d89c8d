// What a run did, as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "craze/mesh/repair.h"
#include "craze/scenario/recipe.h"

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

/// Wall-clock seconds. The parts do not sum to the total: a run does other things too.
struct RunTimes {
  double total = 0, load = 0, prepare = 0, relax = 0, separation = 0, crack = 0, write = 0;
};

struct RunReport {
  Recipe recipe;
  int threads = 1;
  MeshCounts input;       ///< as the file holds it
  MeshCounts simulation;  ///< before the first crack
  MeshCounts output;
  RepairReport repair;
  CrackCounts cracks;
  RunTimes time;
  double load = 0;  ///< load factor at the end
  std::string stop_reason;
  std::vector<std::string> warnings;  ///< what could not be done as asked
  nlohmann::ordered_json statistics = nlohmann::ordered_json::object();
};

/// Keys: version seed threads engine; input, simulation, output .{vertices,triangles};
/// cracks.{events,segments,length,fragments}; load; stop_reason; warnings;
/// time.{total,load,prepare,relax,separation,crack,write}; statistics; repair; recipe.
nlohmann::ordered_json report_to_json(const RunReport& report);

/// What repair found and did, one number per kind.
nlohmann::ordered_json repair_to_json(const RepairReport& repair);

}  // namespace craze
