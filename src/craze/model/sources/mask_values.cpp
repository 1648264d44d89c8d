#include "craze/model/sources/mask_values.h"

#include <algorithm>

#include "craze/error.h"
#include "craze/model/sources/input_fields.h"

namespace craze {

namespace {

constexpr double slack = 1e-6;

bool is_share(double x) {
  return x >= -slack && x <= 1 + slack;
}

}  // namespace

std::vector<double> mask_shares(std::vector<double> values, const char* element) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!is_share(values[i])) {
      throw Error(ErrorKind::request, "cannot use painted values", "where.attribute",
                  "it is " + std::to_string(values[i]) + " at " + element + " " +
                      std::to_string(i) + "; it must be in 0 ... 1");
    }
    values[i] = std::clamp(values[i], 0.0, 1.0);
  }
  return values;
}

std::vector<std::string> mask_names(const SurfaceMesh& surface) {
  std::vector<std::string> names;
  for (const Attribute& a : input_fields(surface).vertex_attributes) {
    if (a.components != 1 || a.values.size() != surface.positions.size()) continue;
    if (std::all_of(a.values.begin(), a.values.end(), is_share)) names.push_back(a.name);
  }
  return names;
}

std::vector<double> mask_at_vertices(const SurfaceMesh& surface, const std::string& name) {
  const InputFields fields = input_fields(surface);
  const Attribute* found = find_attribute(fields.vertex_attributes, name);
  if (!found || found->components != 1 || found->values.size() != surface.positions.size()) {
    throw Error(ErrorKind::request, "cannot use painted values", name,
                "the input has no number of that name per vertex");
  }
  return mask_shares(found->values, "vertex");
}

void set_mask_from_picture(const SurfaceMesh& surface, std::int32_t material,
                           const GreyImage& picture, const Eigen::Matrix<double, 2, 3>& place,
                           double* values) {
  if (picture.empty() || surface.corner_uvs.empty()) {
    throw Error(ErrorKind::request, "cannot use painted values", "picture",
                picture.empty() ? "it has no pixels"
                                : "the input has no texture coordinates (UVs), so a picture has "
                                  "no place on it");
  }
  const std::size_t vertices = surface.positions.size();
  std::vector<double> sum(vertices, 0.0), corners(vertices, 0.0);
  for (std::size_t f = 0; f < surface.face_materials.size(); ++f) {
    if (surface.face_materials[f] != material) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2& uv = surface.corner_uvs[3 * f + i];
      const auto v = static_cast<std::size_t>(surface.triangles[f][i]);
      sum[v] += picture.sample(place * Vec3(uv.x(), uv.y(), 1));
      corners[v] += 1;
    }
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    if (corners[v] > 0) values[v] = std::clamp(sum[v] / corners[v], 0.0, 1.0);
  }
}

}  // namespace craze
