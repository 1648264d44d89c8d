#include "craze/output/lost_data.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "craze/base/text/format.h"
#include "craze/io/source_scene.h"
#include "craze/mesh/run_attributes.h"

namespace craze {

namespace {

/// The things of that kind in the scene, of which its own warning tells.
std::vector<std::string> counted(const SourceScene* scene, std::string_view kind) {
  if (!scene) return {};
  for (SceneContent& content : scene->contents()) {
    if (content.kind == kind) return std::move(content.names);
  }
  return {};
}

/// `told`: the names that are told of elsewhere.
void name_attributes(const std::vector<Attribute>& attributes, const char* of, bool without_colors,
                     const std::vector<std::string>& told, std::vector<std::string>& lost) {
  for (const Attribute& a : attributes) {
    if (is_run_attribute(a.name)) continue;
    if (std::find(told.begin(), told.end(), a.name) != told.end()) continue;
    const bool is_color = a.name == "red" || a.name == "green" || a.name == "blue";
    if (without_colors && is_color) continue;
    lost.push_back(std::string(of) + " attribute '" + a.name + "'");
  }
}

/// Attributes whose whole numbers single precision rounds, such as the ids of a large scan.
std::vector<std::string> rounded_attributes(const std::vector<Attribute>& attributes) {
  std::vector<std::string> names;
  for (const Attribute& a : attributes) {
    const bool is_rounded = std::any_of(a.values.begin(), a.values.end(), [](double x) {
      return x == std::floor(x) && static_cast<double>(static_cast<float>(x)) != x;
    });
    if (is_rounded && !is_run_attribute(a.name)) names.push_back("'" + a.name + "'");
  }
  return names;
}

}  // namespace

std::string describe_rounded_data(const SurfaceMesh& surface, std::string_view format) {
  if (format != "glb") return {};
  const std::vector<std::string> rounded = rounded_attributes(surface.vertex_attributes);
  if (rounded.empty()) return {};
  return fmt::format(
      "whole numbers of vertex attributes are rounded, since .glb holds single precision: {}",
      fmt::join(rounded, ", "));
}

std::string describe_lost_data(const SurfaceMesh& surface, std::string_view format,
                               const SourceScene* scene) {
  const bool is_stl = format == "stl", is_obj = format == "obj", is_glb = format == "glb";
  std::vector<std::string> lost;
  if (is_stl) {
    if (!surface.corner_uvs.empty()) lost.emplace_back("texture coordinates");
    if (!surface.corner_normals.empty()) lost.emplace_back("normals of vertices");
    if (!surface.vertex_colors.empty()) lost.emplace_back("colours of vertices");
    if (!surface.face_materials.empty() && counted(scene, "materials").empty()) {
      lost.emplace_back("materials");
    }
  }
  if (is_stl || is_obj) {
    name_attributes(surface.vertex_attributes, "vertex", false,
                    counted(scene, "vertex attributes of its own"), lost);
  }
  if (is_stl || is_obj || is_glb) {
    name_attributes(surface.face_attributes, "face", is_stl, {}, lost);
  }
  if (lost.empty()) return {};
  return fmt::format("not kept of the surface, since .{} has no place for them: {}", format,
                     fmt::join(lost, ", "));
}

std::string describe_unit(double metres_per_unit, std::string_view format) {
  if (format != "glb" || metres_per_unit == 0 || metres_per_unit == 1) return {};
  return fmt::format(
      "glTF is in metres (mesh.unit): one unit of the mesh, {0:g} m, is 1 m in the .glb; scale it "
      "by {0:g} where it is used",
      metres_per_unit);
}

std::string describe_replaced_data(const SurfaceMesh& surface) {
  std::vector<std::string> replaced;
  for (const auto* attributes : {&surface.vertex_attributes, &surface.face_attributes}) {
    for (const Attribute& a : *attributes) {
      if (is_run_attribute(a.name)) replaced.push_back("'" + a.name + "'");
    }
  }
  if (replaced.empty()) return {};
  return fmt::format("attributes that the surface had are replaced by those of this run: {}",
                     fmt::join(replaced, ", "));
}

}  // namespace craze
