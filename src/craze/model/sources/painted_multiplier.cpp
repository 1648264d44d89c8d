#include "craze/model/sources/painted_multiplier.h"

#include <string>

#include "craze/error.h"

namespace craze {

namespace {

void multiply(std::vector<double>& factors, const std::vector<double>& painted,
              const std::string& key, const char* element) {
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (painted[i] < 0) {
      throw Error(ErrorKind::request, "cannot use painted values", key,
                  "the factor is " + std::to_string(painted[i]) + " at " + element + " " +
                      std::to_string(i) + "; it must not be negative");
    }
    factors[i] *= painted[i];
  }
}

PaintedMultiplier painted(const TriangleMesh& mesh, const InputFields& fields,
                          const std::string& section, const std::string& attribute,
                          const std::string& texture, const GreyImage& image) {
  PaintedMultiplier m;
  m.face.assign(mesh.face_count(), 1.0);
  m.vertex.assign(mesh.vertex_count(), 1.0);
  if (!attribute.empty()) {
    const std::string key = section + ".attribute";
    multiply(m.face, scalar_per_face(mesh, fields, attribute, key), key, "face");
    multiply(m.vertex, scalar_per_vertex(mesh, fields, attribute, key), key, "vertex");
  }
  if (!texture.empty()) {
    const std::string key = section + ".texture";
    multiply(m.face, texture_per_face(mesh, fields, image, key), key, "face");
    multiply(m.vertex, texture_per_vertex(mesh, fields, image, key), key, "vertex");
  }
  return m;
}

bool attribute_is_the_only_source(const SimulationParameters& p) {
  const StressParameters& s = p.stress;
  bool tensor = false;
  for (const double x : s.tensor) tensor = tensor || x != 0;
  return !s.attribute.empty() && s.uniform == 0 && !tensor && s.curvature == 0 &&
         p.impacts.empty() && p.evolution.shrinkage == 0 && p.evolution.curvature_growth == 0;
}

}  // namespace

PaintedMultiplier material_multiplier(const TriangleMesh& mesh, const MaterialParameters& material,
                                      const InputFields& fields) {
  return painted(mesh, fields, "material", material.attribute, material.texture,
                 fields.material_texture);
}

PaintedMultiplier spacing_multiplier(const TriangleMesh& mesh, const LayerParameters& layer,
                                     const InputFields& fields) {
  return painted(mesh, fields, "layer", layer.attribute, layer.texture, fields.layer_texture);
}

std::vector<std::uint8_t> faces_with_zero_attribute(const TriangleMesh& mesh,
                                                    const SimulationParameters& parameters,
                                                    const InputFields& fields) {
  std::vector<std::uint8_t> zero(mesh.face_count(), 0);
  const auto look = [&](const char* section, const std::string& attribute) {
    if (attribute.empty()) return;
    const PaintedMultiplier m = painted(mesh, fields, section, attribute, "", {});
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      const Triangle& t = mesh.triangle(f);
      if (m.face[f] == 0 || m.vertex[t[0]] == 0 || m.vertex[t[1]] == 0 || m.vertex[t[2]] == 0) {
        zero[f] = 1;
      }
    }
  };
  look("material", parameters.material.attribute);
  look("layer", parameters.layer.attribute);
  return zero;
}

std::vector<std::uint8_t> forbidden_faces(const TriangleMesh& mesh,
                                          const SimulationParameters& parameters,
                                          const InputFields& fields) {
  std::vector<std::uint8_t> forbidden = faces_with_zero_attribute(mesh, parameters, fields);
  const auto forbid_black = [&](const GreyImage& image, const char* key) {
    if (image.empty()) return;
    const std::vector<std::uint8_t> black = black_faces(mesh, fields, image, key);
    for (std::size_t f = 0; f < forbidden.size(); ++f) forbidden[f] |= black[f];
  };
  forbid_black(fields.stress_texture, "stress.texture");
  forbid_black(fields.material_texture, "material.texture");
  forbid_black(fields.layer_texture, "layer.texture");
  if (attribute_is_the_only_source(parameters)) {
    const auto stress =
        tensor_per_face(mesh, fields, parameters.stress.attribute, "stress.attribute");
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      if (stress[f].matrix().isZero(0)) forbidden[f] = 1;
    }
  }
  return forbidden;
}

}  // namespace craze
