// Scenes for tests: glTF documents built here, and looked into when they come back.
#pragma once

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "craze/io/bytes/byte_order.h"
#include "craze/read_mesh.h"
#include "craze/surface_origin.h"
#include "craze/write_mesh.h"

namespace craze {

using Json = nlohmann::json;

/// A GLB under construction or taken apart.
struct SceneFile {
  Json json;
  std::string bin;

  SceneFile() {
    json = Json::parse(R"({"asset": {"version": "2.0", "generator": "by hand", "extras": {"a": 1}},
      "scene": 0, "scenes": [{"name": "all", "nodes": []}], "nodes": [], "meshes": [],
      "accessors": [], "bufferViews": [], "buffers": [{"name": "data"}]})");
  }
  explicit SceneFile(const std::string& glb) {
    const auto size = load<std::uint32_t>(glb.data() + 12);
    json = Json::parse(glb.substr(20, size));
    if (glb.size() > 28 + size) bin = glb.substr(28 + size);
  }

  std::size_t add_view(const std::string& bytes, std::size_t stride = 0) {
    bin.resize((bin.size() + 3) / 4 * 4, '\0');
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}});
    if (stride > 0) json["bufferViews"].back()["byteStride"] = stride;
    bin += bytes;
    return json["bufferViews"].size() - 1;
  }
  template <class T>
  std::size_t add(const std::vector<T>& numbers, const char* type, int component_type,
                  std::size_t components, bool normalized = false) {
    std::string bytes;
    std::size_t stride = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      append(bytes, numbers[i]);
      // Vertices begin at whole words.
      if ((i + 1) % components == 0 && std::string(type) != "SCALAR") {
        const std::size_t packed = bytes.size();
        bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
        if (bytes.size() != packed) stride = (components * sizeof(T) + 3) / 4 * 4;
      }
    }
    json["accessors"].push_back({{"bufferView", add_view(bytes, stride)},
                                 {"componentType", component_type},
                                 {"count", numbers.size() / components},
                                 {"type", type}});
    if (normalized) json["accessors"].back()["normalized"] = true;
    return json["accessors"].size() - 1;
  }
  std::size_t add_positions(const std::vector<float>& p) {
    const std::size_t accessor = add(p, "VEC3", 5126, 3);
    std::vector<float> low(3, 1e30f), high(3, -1e30f);
    for (std::size_t i = 0; i < p.size(); ++i) {
      low[i % 3] = std::min(low[i % 3], p[i]);
      high[i % 3] = std::max(high[i % 3], p[i]);
    }
    json["accessors"][accessor]["min"] = low;
    json["accessors"][accessor]["max"] = high;
    return accessor;
  }

  std::string bytes() const {
    Json whole = json;
    whole["buffers"][0]["byteLength"] = bin.size();
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string file = "glTF";
    append(file, std::uint32_t{2});
    append(file, static_cast<std::uint32_t>(28 + text.size() + bin.size()));
    append(file, static_cast<std::uint32_t>(text.size()));
    file += "JSON" + text;
    append(file, static_cast<std::uint32_t>(bin.size()));
    file.append("BIN\0", 4);
    return file + bin;
  }

  /// An accessor's elements, packed, as they are stored.
  std::string elements(std::size_t number) const {
    const Json& accessor = json["accessors"][number];
    const std::map<int, std::size_t> sizes{{5120, 1}, {5121, 1}, {5122, 2},
                                           {5123, 2}, {5125, 4}, {5126, 4}};
    const std::map<std::string, std::size_t> counts{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3},
                                                    {"VEC4", 4},   {"MAT2", 4}, {"MAT3", 9},
                                                    {"MAT4", 16}};
    const std::size_t size = sizes.at(accessor["componentType"]) * counts.at(accessor["type"]);
    const std::size_t count = accessor["count"];
    std::string all(count * size, '\0');
    const auto range = [&](const Json& of) {
      const Json& view = json["bufferViews"][of["bufferView"].get<std::size_t>()];
      return view.value("byteOffset", std::size_t{0}) + of.value("byteOffset", std::size_t{0});
    };
    if (accessor.contains("bufferView")) {
      const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
      const std::size_t stride = view.value("byteStride", size);
      for (std::size_t i = 0; i < count; ++i) {
        all.replace(i * size, size, bin.substr(range(accessor) + i * stride, size));
      }
    }
    if (accessor.contains("sparse")) {
      const Json& sparse = accessor["sparse"];
      for (std::size_t i = 0; i < sparse["count"].get<std::size_t>(); ++i) {
        const auto at = load<std::uint32_t>(bin.data() + range(sparse["indices"]) + 4 * i);
        all.replace(at * size, size, bin.substr(range(sparse["values"]) + i * size, size));
      }
    }
    return all;
  }
  std::vector<float> floats(std::size_t number) const {
    const std::string packed = elements(number);
    std::vector<float> numbers;
    for (std::size_t i = 0; i < packed.size(); i += 4) {
      numbers.push_back(load<float>(packed.data() + i));
    }
    return numbers;
  }
  std::string view(std::size_t number) const {
    const Json& v = json["bufferViews"][number];
    return bin.substr(v.value("byteOffset", std::size_t{0}), v["byteLength"].get<std::size_t>());
  }
  const Json& primitive(std::size_t mesh, std::size_t p) const {
    return json["meshes"][mesh]["primitives"][p];
  }
  std::vector<std::string> names(const char* list) const {
    std::vector<std::string> all;
    if (!json.contains(list)) return all;
    for (const Json& item : json[list]) all.push_back(item.value("name", std::string()));
    return all;
  }
};

/// A cut mesh on a surface that was read, at first the surface itself.
struct HandCut {
  SurfaceMesh mesh;
  SurfaceOrigin origin;
  std::vector<std::int32_t> crack_edges;

  explicit HandCut(const SurfaceMesh& surface) : mesh(surface) {
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      origin.face.push_back(static_cast<std::int32_t>(f));
      for (int i = 0; i < 3; ++i) origin.weights.push_back(Vec3::Unit(i));
    }
    origin.wall_begin = static_cast<std::int32_t>(mesh.triangles.size());
  }

  /// Cuts face f from the middle of its first edge to the corner across: two faces, apart.
  void cut(std::int32_t f) {
    const auto [a, b, c] = mesh.triangles[f];
    const Vec3 middle = 0.5 * (mesh.positions[a] + mesh.positions[b]);
    const auto add = [&](const Vec3& p) {
      mesh.positions.push_back(p);
      return static_cast<std::int32_t>(mesh.positions.size()) - 1;
    };
    const std::int32_t left = add(middle), right = add(middle), other = add(mesh.positions[c]);
    mesh.triangles[f] = {a, left, c};
    const Vec3 half(0.5, 0.5, 0);
    origin.weights[3 * f + 1] = half;
    mesh.triangles.push_back({right, b, other});
    origin.face.push_back(origin.face[f]);
    for (const Vec3& w : {half, Vec3(0, 1, 0), Vec3(0, 0, 1)}) origin.weights.push_back(w);
    origin.wall_begin = static_cast<std::int32_t>(mesh.triangles.size());
    crack_edges.push_back(3 * f + 1);
    mesh.corner_uvs.clear();
    mesh.corner_normals.clear();
    mesh.vertex_colors.clear();
    mesh.vertex_attributes.clear();
    mesh.face_materials.clear();
    mesh.material_names.clear();
    mesh.face_objects.clear();
    mesh.source_faces.clear();
  }
  /// The vertices of the side of the last cut that has b.
  std::array<std::int32_t, 3> far_side() const { return mesh.triangles.back(); }

  /// A wall below corners i and j of a face, of that depth along −z.
  void wall(std::int32_t f, int i, int j, double depth) {
    const std::size_t corner = 3 * static_cast<std::size_t>(f);
    const auto n = static_cast<std::int32_t>(mesh.positions.size());
    const std::int32_t p = mesh.triangles[f][static_cast<std::size_t>(i)];
    const std::int32_t q = mesh.triangles[f][static_cast<std::size_t>(j)];
    for (const std::int32_t v : {p, q}) {
      mesh.positions.push_back(mesh.positions[v] - depth * Vec3::UnitZ());
    }
    const Vec3 at_p = origin.weights[corner + static_cast<std::size_t>(i)];
    const Vec3 at_q = origin.weights[corner + static_cast<std::size_t>(j)];
    for (const auto& [t, w] : {std::pair{Triangle{p, n, n + 1}, std::array{at_p, at_p, at_q}},
                               {Triangle{p, n + 1, q}, std::array{at_p, at_q, at_q}}}) {
      mesh.triangles.push_back(t);
      origin.face.push_back(origin.face[f]);
      origin.weights.insert(origin.weights.end(), w.begin(), w.end());
    }
  }

  MeshFileOptions options(const MeshFile& file) const {
    MeshFileOptions options;
    options.scene = file.scene;
    options.origin = &origin;
    options.crack_edges = crack_edges;
    return options;
  }
  SceneFile write(const MeshFile& file) const {
    return SceneFile(format_mesh(mesh, "glb", options(file)));
  }
};

}  // namespace craze
