// What of a mesh may serve as a mask.
#include <nlohmann/json.hpp>

#include "craze/model/sources/mask_values.h"
#include "given_picture.h"
#include "guard.h"
#include "handles.h"

using namespace craze;
using namespace craze::c;

namespace {

/// How a material looks; throws Error(usage) where there is no such one. Meshes that were not read
/// have materials without looks.
MaterialLook look_of(const craze_mesh& mesh, int64_t material) {
  if (material < 0 || material >= static_cast<int64_t>(mesh.mesh->material_names.size())) {
    throw Error(ErrorKind::usage, "wrong material", std::to_string(material),
                "the mesh has " + std::to_string(mesh.mesh->material_names.size()));
  }
  const auto i = static_cast<std::size_t>(material);
  if (!mesh.source || i >= mesh.source->looks.size()) return {};
  return mesh.source->looks[i];
}

}  // namespace

char* craze_mesh_masks(const craze_mesh* mesh, craze_error* error) {
  return guarded(error, [&] {
    require(mesh, "mesh");
    constexpr auto replace = nlohmann::json::error_handler_t::replace;  // what is no UTF-8
    return copy_text(nlohmann::json(mask_names(*mesh->mesh)).dump(-1, ' ', false, replace));
  });
}

craze_status craze_mesh_mask(const craze_mesh* mesh, const char* name, double* values,
                             craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    require(name, "name");
    require(values, "values");
    const std::vector<double> found = mask_at_vertices(*mesh->mesh, name);
    std::copy(found.begin(), found.end(), values);
  });
}

craze_status craze_mesh_texture(const craze_mesh* mesh, int64_t material, craze_array* file,
                                craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    require(file, "file");
    const MaterialLook look = look_of(*mesh, material);
    *file = {nullptr, 0, 1, CRAZE_UINT8};
    const auto& bytes = look.base_picture.bytes;
    if (!bytes) return;
    // The mesh's source keeps them.
    *file = {bytes->data(), static_cast<int64_t>(bytes->size()), 1, CRAZE_UINT8};
  });
}

craze_status craze_mesh_mask_picture(const craze_mesh* mesh, int64_t material, const void* pixels,
                                     craze_type type, int64_t width, int64_t height,
                                     int32_t channels, double* values, craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    require(values, "values");
    const MaterialLook look = look_of(*mesh, material);
    const GreyImage picture = grey_picture(pixels, type, width, height, channels, "picture");
    set_mask_from_picture(*mesh->mesh, static_cast<std::int32_t>(material), picture,
                          look.base_picture.place, values);
  });
}
