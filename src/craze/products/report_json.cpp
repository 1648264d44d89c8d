#include "craze/products/report_json.h"

#include <nlohmann/json.hpp>

#include "craze/base/version.h"
#include "craze/recipe/recipe_json.h"

namespace craze {

namespace {

nlohmann::ordered_json to_json(const MeshCounts& counts) {
  return {{"vertices", counts.vertices}, {"triangles", counts.triangles}};
}

}  // namespace

nlohmann::ordered_json repair_to_json(const RepairReport& r) {
  return {{"merged_vertices", r.merged_vertices},
          {"unused_vertices", r.unused_vertices},
          {"degenerate_faces", r.degenerate_faces},
          {"duplicate_faces", r.duplicate_faces},
          {"flipped_faces", r.flipped_faces},
          {"nonmanifold_edges", r.nonmanifold_edges},
          {"cut_edges", r.cut_edges},
          {"split_vertices", r.split_vertices},
          {"inserted_vertices", r.inserted_vertices},
          {"components", r.components},
          {"boundary_loops", r.boundary_loops}};
}

nlohmann::ordered_json report_to_json(const Report& r,
                                      const StatisticsWithSensitivity* statistics) {
  const nlohmann::ordered_json recipe = recipe_to_json(r.recipe);
  return {{"version", version()},
          {"seed", recipe["seed"]},
          {"threads", r.threads},
          {"engine", recipe["engine"]},
          {"input", to_json(r.input)},
          {"simulation", to_json(r.simulation)},
          {"output", to_json(r.output)},
          {"cracks",
           {{"events", r.cracks.events},
            {"segments", r.cracks.segments},
            {"length", r.cracks.length},
            {"fragments", r.cracks.fragments}}},
          {"carried",
           {{"split_triangles", r.carried.split_triangles},
            {"added_triangles", r.carried.added_triangles},
            {"rerouted_pieces", r.carried.rerouted_pieces},
            {"lost_pieces", r.carried.lost_pieces},
            {"lost_length", r.carried.lost_length}}},
          {"load", r.load},
          {"stop_reason", r.stop_reason},
          {"warnings", r.warnings},
          {"time",
           {{"total", r.time.total},
            {"load", r.time.load},
            {"prepare", r.time.prepare},
            {"relax", r.time.relax},
            {"separation", r.time.separation},
            {"crack", r.time.crack},
            {"carry", r.time.carry},
            {"write", r.time.write}}},
          {"statistics", statistics ? to_json(*statistics, {}) : nlohmann::ordered_json::object()},
          {"repair", repair_to_json(r.repair)},
          {"recipe", recipe}};
}

std::string report_text(const Report& report, const StatisticsWithSensitivity* statistics) {
  constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
  return report_to_json(report, statistics).dump(2, ' ', false, replace);
}

}  // namespace craze
