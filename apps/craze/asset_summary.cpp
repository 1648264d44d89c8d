#include "asset_summary.h"
#include "craze/base/text/format.h"

#include <cmath>
#include <map>
#include <string>

namespace craze::app {

namespace {

using Names = std::map<std::string, std::int64_t>;  // how many triangles have each name

Names count_names(const std::vector<std::int32_t>& index, const std::vector<std::string>& names) {
  Names count;
  for (const std::int32_t i : index) {
    if (i >= 0) ++count[names[static_cast<std::size_t>(i)]];
  }
  return count;
}

std::string names_text(const char* what, const Names& names) {
  constexpr std::size_t most = 20;
  std::string text;
  std::size_t shown = 0;
  for (const auto& [name, triangles] : names) {
    if (shown++ == most) break;
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", name, triangles);
  }
  if (names.size() > most) text += fmt::format(" and {} more; --json has all", names.size() - most);
  return fmt::format("{}: {}\n", what, names.empty() ? "none" : text + " triangles");
}

nlohmann::ordered_json names_json(const Names& names) {
  auto list = nlohmann::ordered_json::array();
  for (const auto& [name, triangles] : names) {
    list.push_back({{"name", name}, {"triangles", triangles}});
  }
  return list;
}

/// To two digits.
double rounded(double x) {
  return std::stod(fmt::format("{:.1e}", x));
}

/// A spacing that shows a pattern all over: about that of the presets.
double suggested_spacing(double diagonal) {
  constexpr double of_diagonal = 0.06;
  return rounded(of_diagonal * diagonal);
}

/// "0.043", or with the unit that shows it best where it is known: "43mm".
std::string length_text(double length, double metres_per_unit) {
  if (metres_per_unit == 0 || length == 0) return fmt::format("{:.4g}", length);
  const double metres = length * metres_per_unit;
  if (metres >= 1) return fmt::format("{:.4g}m", metres);
  return metres >= 0.001 ? fmt::format("{:.4g}mm", 1000 * metres)
                         : fmt::format("{:.4g}um", 1e6 * metres);
}

}  // namespace

std::string asset_text(const std::string& file, const SurfaceMesh& mesh, const Vec3& size,
                       double diagonal) {
  const double unit = mesh.metres_per_unit;
  std::string text =
      unit == 0
          ? "unit: not known; mesh.unit gives it a meaning in millimetres\n"
          : fmt::format("unit: {:g} m; size {} x {} x {}\n", unit, length_text(size.x(), unit),
                        length_text(size.y(), unit), length_text(size.z(), unit));
  text += names_text("materials", count_names(mesh.face_materials, mesh.material_names));
  text += names_text("nodes", count_names(mesh.face_objects, mesh.object_names));
  text += fmt::format("UV sets: {}\n", mesh.corner_uvs.empty() ? 0 : 1);
  const double spacing = suggested_spacing(diagonal);
  if (spacing == 0) return text;
  const std::string shown = length_text(spacing, unit);
  text += fmt::format("a spacing to begin with: {}\n", shown);
  for (const char* preset : {"glaze", "mud"}) {
    text += fmt::format("  craze crack '{}' -o cracked.glb --preset {} --set layer.spacing={}\n",
                        file, preset, shown);
  }
  return text;
}

nlohmann::ordered_json asset_json(const SurfaceMesh& mesh, double diagonal) {
  const double unit = mesh.metres_per_unit;
  return {{"metres_per_unit", unit == 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(unit)},
          {"materials", names_json(count_names(mesh.face_materials, mesh.material_names))},
          {"nodes", names_json(count_names(mesh.face_objects, mesh.object_names))},
          {"uv_sets", mesh.corner_uvs.empty() ? 0 : 1},
          {"suggested_spacing", suggested_spacing(diagonal)}};
}

}  // namespace craze::app
