#include "craze/io/gltf/scene/uvs/uv_sets.h"

#include <algorithm>
#include <map>
#include <string>

#include "craze/io/gltf/gltf_primitive.h"

namespace craze {

namespace {

const Json& primitive_of(const GltfDocument& document, const GltfPart& part) {
  return document.root()["meshes"][part.mesh]["primitives"][part.primitive];
}

}  // namespace

UvSet uv_set(const GltfDocument& document, std::size_t number) {
  const std::string key = "TEXCOORD_" + std::to_string(number);
  const FileLoader no_files;
  constexpr std::size_t most_zeros = 4'000'000;
  GltfAccessors accessors(document.root(), document.bin(), no_files,
                          document.bin().size() + most_zeros, document_name);
  UvSet set;
  set.corners.assign(3 * document.triangles().size(), Vec2::Zero());
  set.has.assign(document.triangles().size(), 0);
  std::map<std::int32_t, GltfAccessors::Values> read;  // by the first vertex of the parts
  for (const GltfPart& part : document.parts()) {
    const Json& json = primitive_of(document, part);
    if (!json["attributes"].contains(key)) continue;
    auto known = read.find(part.first_vertex);
    if (known == read.end()) {
      const std::vector<double> weights =
          morph_weights(document.root()["meshes"][part.mesh], &document.root()["nodes"][part.node],
                        GltfJson(document_name));
      GltfPrimitive primitive(
          json, weights, accessors, [](std::size_t) {}, document_name);
      known = read.emplace(part.first_vertex, primitive.read(key.c_str(), 2, 2)).first;
    }
    for (std::int32_t f = part.first_face; f < part.end_face; ++f) {
      set.has[f] = 1;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t v =
            2 * static_cast<std::size_t>(document.triangles()[f][i] - part.first_vertex);
        set.corners[3 * static_cast<std::size_t>(f) + i] = {known->second.values[v],
                                                            1 - known->second.values[v + 1]};
      }
    }
  }
  return set;
}

std::size_t uv_set_count(const GltfDocument& document) {
  std::set<std::int32_t> all;
  for (const GltfPart& part : document.parts()) all.insert(material_of(document, part));
  return uv_set_count(document, all);
}

std::size_t uv_set_count(const GltfDocument& document, const std::set<std::int32_t>& materials) {
  std::size_t count = 0;
  for (const GltfPart& part : document.parts()) {
    if (materials.count(material_of(document, part)) == 0) continue;
    const Json& attributes = primitive_of(document, part)["attributes"];
    // Some files begin with another than the first, or leave one out.
    for (std::size_t n = count; n < most_uv_sets; ++n) {
      if (attributes.contains("TEXCOORD_" + std::to_string(n))) count = n + 1;
    }
  }
  return count;
}

std::int32_t material_of(const GltfDocument& document, const GltfPart& part) {
  const Json& primitive = primitive_of(document, part);
  const auto material = primitive.find("material");
  return material == primitive.end() ? -1 : material->get<std::int32_t>();
}

}  // namespace craze
