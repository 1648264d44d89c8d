// craze check MESH: what a mesh is, and what repair would do to it.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app.h"
#include "craze/job/load_surface.h"
#include "craze/mesh/mesh_summary.h"
#include "craze/products/report_json.h"
#include "craze/repair.h"

namespace craze::app {

namespace {

/// What the file has besides triangles.
std::vector<std::string> extras(const SurfaceMesh& mesh) {
  std::vector<std::string> names;
  if (!mesh.corner_uvs.empty()) names.emplace_back("uvs");
  if (!mesh.corner_normals.empty()) names.emplace_back("normals");
  if (!mesh.vertex_colors.empty()) names.emplace_back("colors");
  if (!mesh.face_materials.empty()) names.emplace_back("materials");
  for (const Attribute& a : mesh.vertex_attributes) names.push_back("vertex " + a.name);
  for (const Attribute& a : mesh.face_attributes) names.push_back("face " + a.name);
  return names;
}

std::string as_text(const SurfaceMesh& input, const MeshSummary& s, const RepairReport& repair) {
  std::string text =
      fmt::format("{} vertices, {} triangles\n", input.positions.size(), input.triangles.size());
  const std::string repairs = repair.text();
  text += repairs.empty() ? "nothing to repair\n" : "repair: " + repairs + "\n";
  text += fmt::format("after repair: {} vertices, {} triangles, {} component(s), {}\n", s.vertices,
                      s.faces, s.components,
                      s.closed() ? fmt::format("closed, genus {}", s.genus)
                                 : fmt::format("{} boundary loop(s)", s.boundary_loops));
  text += fmt::format("area {:.6g}, diagonal {:.6g}, edges {:.4g} to {:.4g}, mean {:.4g}\n", s.area,
                      s.diagonal, s.edge_min, s.edge_max, s.edge_mean);
  if (s.closed()) text += fmt::format("volume {:.6g}\n", s.volume);
  text += fmt::format("worst triangle {:.3g} times as long as high\n", s.worst_aspect);
  std::string list;
  for (const std::string& name : extras(input)) list += (list.empty() ? "" : ", ") + name;
  return text + "attributes: " + (list.empty() ? "none" : list) + "\n";
}

nlohmann::ordered_json as_json(const SurfaceMesh& input, const MeshSummary& s,
                               const RepairReport& repair) {
  return {{"input", {{"vertices", input.positions.size()}, {"triangles", input.triangles.size()}}},
          {"repaired",
           {{"vertices", s.vertices},
            {"triangles", s.faces},
            {"components", s.components},
            {"boundary_loops", s.boundary_loops},
            {"euler_characteristic", s.euler_characteristic},
            {"closed", s.closed()},
            {"genus", s.genus},
            {"area", s.area},
            {"volume", s.volume},
            {"diagonal", s.diagonal},
            {"edge_min", s.edge_min},
            {"edge_mean", s.edge_mean},
            {"edge_max", s.edge_max},
            {"worst_aspect", s.worst_aspect}}},
          {"repair", repair_to_json(repair)},
          {"sound", !repair.defects()},
          {"attributes", extras(input)}};
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  struct Options {
    std::string input;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("check", "Say what a mesh is and what repair would do");
  verb->add_option("MESH", options->input, "A mesh file, or shape:NAME?key=value&...")
      ->required()
      ->type_name("");
  verb->add_flag("--json", options->json, "As JSON");
  verb->footer(
      "Examples:\n"
      "  craze check scan.stl\n"
      "  craze check scan.stl --json | jq .repair");
  verb->callback([options, &action] {
    action = [options] {
      const SurfaceMesh input = load_surface(options->input);
      RepairReport report;
      const SurfaceMesh repaired = repair(input, {}, report);
      const MeshSummary summary = summarize(TriangleMesh(repaired.positions, repaired.triangles));
      if (!options->json) return print(as_text(input, summary, report));
      return print(as_json(input, summary, report).dump(2) + "\n");
    };
  });
}

}  // namespace craze::app
