#include "craze/engine/welded_values.h"

#include <algorithm>

#include "craze/mesh/run_attributes.h"

namespace craze {

namespace {

bool is_same(const std::vector<double>& a, std::int32_t v, const std::vector<double>& b,
             std::int32_t w, int components) {
  const auto at = [&](const std::vector<double>& values, std::int32_t i) {
    return values.begin() + static_cast<std::ptrdiff_t>(i) * components;
  };
  return std::equal(at(a, v), at(a, v) + components, at(b, w));
}

}  // namespace

std::shared_ptr<const SurfaceMesh> lost_by_welding(const SurfaceMesh& input,
                                                   const TracedSurface& traced) {
  const SurfaceMesh& made = traced.surface;
  const auto loses = [&](const auto& differ) {
    for (std::size_t c = 0; c < 3 * made.triangles.size(); ++c) {
      const auto [corner, other] = traced.origin.corners[c];
      if (corner != other) continue;
      const auto face = static_cast<std::size_t>(traced.origin.face[c / 3]);
      if (differ(input.triangles[face][corner], made.triangles[c / 3][c % 3])) {
        return true;
      }
    }
    return false;
  };
  bool any = !input.vertex_colors.empty() && loses([&](std::int32_t v, std::int32_t w) {
    return input.vertex_colors[v] != made.vertex_colors[w];
  });
  for (const Attribute& a : input.vertex_attributes) {
    const Attribute* kept = find_attribute(made.vertex_attributes, a.name);
    if (any || !kept || is_run_attribute(a.name)) continue;
    any = loses([&](std::int32_t v, std::int32_t w) {
      return !is_same(a.values, v, kept->values, w, a.components);
    });
  }
  if (!any) return nullptr;
  auto lost = std::make_shared<SurfaceMesh>();
  lost->triangles = input.triangles;
  lost->vertex_colors = input.vertex_colors;
  for (const Attribute& a : input.vertex_attributes) {
    if (!is_run_attribute(a.name)) lost->vertex_attributes.push_back(a);
  }
  return lost;
}

}  // namespace craze
