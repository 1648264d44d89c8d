// Crack patterns as the command makes them.
#pragma once

#include <string>

#include "craze/engine/initial_fields.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/model/screening.h"
#include "craze/model/simulation.h"
#include "craze/presets.h"
#include "craze/repair.h"
#include "craze/shapes.h"

namespace craze::test {

/// A finished run of a preset on a built-in shape, its cracks about `spacing` of the size apart.
inline Simulation cracked(const std::string& shape, const std::string& preset = "mud",
                          double spacing = 0.12, std::uint64_t seed = 1) {
  Recipe recipe = read_preset(preset);
  apply_set(recipe, "layer.relative_spacing=" + std::to_string(spacing));
  apply_set(recipe, "seed=" + std::to_string(seed));
  RepairReport report;
  SurfaceMesh input = repair(make_shape(shape), {}, report);
  recipe.simulation = resolve_lengths(recipe.simulation, bounding_diagonal(input.positions));
  const SimulationSurface surface = simulation_surface(std::move(input), recipe, {});
  TriangleMesh mesh(surface.mesh.positions, surface.mesh.triangles);
  SimulationFields fields = initial_fields(surface, mesh, recipe.simulation, {}, {});
  Simulation simulation(std::move(mesh), std::move(fields), recipe.simulation, {});
  simulation.run({});
  return simulation;
}

inline std::vector<Vec3> displacements(const Simulation& simulation) {
  std::vector<Vec3> u;
  for (std::int32_t v = 0; v < simulation.mesh().vertex_count(); ++v) {
    u.push_back(simulation.displacement(v));
  }
  return u;
}

}  // namespace craze::test
