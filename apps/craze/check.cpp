// craze check MESH: what a mesh is, and what repair would do to it.

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app.h"
#include "asset_summary.h"
#include "craze/base/text/format.h"
#include "craze/io/source_scene.h"
#include "craze/job/load_surface.h"
#include "craze/mesh/mesh_summary.h"
#include "craze/products/report_json.h"
#include "craze/repair.h"
#include "part_boxes.h"
#include "run_options.h"

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

using Box = Eigen::AlignedBox3d;

/// What check says.
struct Checked {
  const std::string& name;
  const MeshFile& file;
  const SurfaceMesh& input = file.mesh;
  std::vector<SceneContent> contents;  ///< what the file holds besides
  RepairReport repair;
  MeshSummary summary;         ///< of the repaired mesh,
  std::vector<PartBox> parts;  ///< and its parts

  Box box() const {
    Box whole;
    for (const PartBox& part : parts) whole.extend(part.box);
    return whole;
  }
};

Checked check(const std::string& name, const MeshFile& file) {
  Checked checked{name, file, file.mesh, {}, {}, {}, {}};
  if (file.scene) checked.contents = file.scene->contents();
  const SurfaceMesh repaired = repair(file.mesh, {}, checked.repair);
  const TriangleMesh mesh(repaired.positions, repaired.triangles);
  checked.summary = summarize(mesh);
  checked.parts = part_boxes(mesh);
  return checked;
}

std::string numbers(const Vec3& v, const char* between) {
  return fmt::format("{:.6g}{}{:.6g}{}{:.6g}", v.x(), between, v.y(), between, v.z());
}

std::string box_text(const Box& box) {
  return fmt::format("box ({}) to ({}), size {}", numbers(box.min(), ", "),
                     numbers(box.max(), ", "), numbers(box.sizes(), " x "));
}

std::string parts_text(const std::vector<PartBox>& parts) {
  constexpr std::size_t most_lines = 20;
  if (parts.size() < 2) return "";
  std::string text;
  for (std::size_t i = 0; i < std::min(parts.size(), most_lines); ++i) {
    text +=
        fmt::format("part {}: {} triangles, {}\n", i, parts[i].triangles, box_text(parts[i].box));
  }
  if (parts.size() > most_lines) {
    text += fmt::format("and {} more parts; --json has all\n", parts.size() - most_lines);
  }
  return text;
}

nlohmann::ordered_json box_json(const Box& box) {
  const auto json = [](const Vec3& v) { return nlohmann::json{v.x(), v.y(), v.z()}; };
  return {{"low", json(box.min())}, {"high", json(box.max())}, {"size", json(box.sizes())}};
}

nlohmann::ordered_json parts_json(const std::vector<PartBox>& parts) {
  nlohmann::ordered_json list = nlohmann::json::array();
  for (const PartBox& part : parts) {
    list.push_back({{"triangles", part.triangles}, {"box", box_json(part.box)}});
  }
  return list;
}

/// "animations in the file: 2 (drive, wave)".
std::string contents_text(const std::vector<SceneContent>& contents) {
  constexpr std::size_t most_names = 8;
  std::string text;
  for (const SceneContent& content : contents) {
    const std::vector<std::string>& names = content.names;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), most_names); ++i) {
      if (!names[i].empty()) list += (list.empty() ? "" : ", ") + names[i];
    }
    if (!list.empty()) {
      list = fmt::format(" ({}{})", list, names.size() > most_names ? ", ..." : "");
    }
    text += fmt::format("{} in the file: {}{}\n", content.kind, names.size(), list);
  }
  return text;
}

std::string as_text(const Checked& checked) {
  const SurfaceMesh& input = checked.input;
  const MeshSummary& s = checked.summary;
  std::string text =
      fmt::format("{} vertices, {} triangles\n", input.positions.size(), input.triangles.size());
  const std::string repairs = checked.repair.text();
  text += repairs.empty() ? "nothing to repair\n" : "repair: " + repairs + "\n";
  text += fmt::format("after repair: {} vertices, {} triangles, {} component(s), {}\n", s.vertices,
                      s.faces, s.components,
                      s.closed() ? fmt::format("closed, genus {}", s.genus)
                                 : fmt::format("{} boundary loop(s)", s.boundary_loops));
  if (!checked.parts.empty()) text += box_text(checked.box()) + "\n" + parts_text(checked.parts);
  text += fmt::format("area {:.6g}, diagonal {:.6g}, edges {:.4g} to {:.4g}, mean {:.4g}\n", s.area,
                      s.diagonal, s.edge_min, s.edge_max, s.edge_mean);
  if (s.closed()) text += fmt::format("volume {:.6g}\n", s.volume);
  text += fmt::format("worst triangle {:.3g} times as long as high\n", s.worst_aspect);
  std::string list;
  for (const std::string& name : extras(input)) list += (list.empty() ? "" : ", ") + name;
  text += "attributes: " + (list.empty() ? "none" : list) + "\n" + contents_text(checked.contents);
  if (checked.parts.empty()) return text;
  return text + asset_text(checked.name, input, checked.box().sizes(), s.diagonal);
}

nlohmann::ordered_json contents_json(const std::vector<SceneContent>& contents) {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  for (const SceneContent& content : contents) all[content.kind] = content.names;
  return all;
}

nlohmann::ordered_json as_json(const Checked& checked) {
  const SurfaceMesh& input = checked.input;
  const MeshSummary& s = checked.summary;
  const Box whole = checked.box();
  nlohmann::ordered_json json = {
      {"input", {{"vertices", input.positions.size()}, {"triangles", input.triangles.size()}}},
      {"repaired",
       {{"vertices", s.vertices},
        {"triangles", s.faces},
        {"components", s.components},
        {"box", whole.isEmpty() ? nlohmann::ordered_json() : box_json(whole)},
        {"parts", parts_json(checked.parts)},
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
      {"repair", repair_to_json(checked.repair)},
      {"sound", !checked.repair.defects()},
      {"attributes", extras(input)},
      {"contents", contents_json(checked.contents)},
      {"warnings", checked.file.warnings}};
  json.update(asset_json(input, s.diagonal));
  return json;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  struct Options {
    std::string input;
    bool json = false, no_warnings = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("check", "Say what a mesh is and what repair would do");
  verb->add_option("MESH", options->input, "A mesh file, or shape:NAME?key=value&...")
      ->required()
      ->type_name("");
  verb->add_flag("--json", options->json, "As JSON");
  add_warning_option(*verb, options->no_warnings);
  verb->footer(
      "Examples:\n"
      "  craze check scan.stl\n"
      "  craze check scan.stl --json | jq .repair");
  verb->callback([options, &action] {
    action = [options] {
      const MeshFile file = load_surface(options->input);
      if (!options->no_warnings) print_warnings({}, file.warnings);
      const Checked checked = check(options->input, file);
      if (!options->json) return print(as_text(checked));
      constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
      return print(as_json(checked).dump(2, ' ', false, replace) + "\n");
    };
  });
}

}  // namespace craze::app
