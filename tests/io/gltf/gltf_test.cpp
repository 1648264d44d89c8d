#include "craze/io/gltf/gltf.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "craze/io/bytes/byte_order.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/files/sibling_files.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

using Json = nlohmann::json;

SurfaceMesh read(const Json& json, const FileLoader& loader = nullptr) {
  return read_mesh(json.dump(), "a.gltf", loader).mesh;
}

/// A file of one mesh: a triangle at (0,0,0) (1,0,0) (0,1,0) and a fourth vertex (1,1,0), in a
/// buffer named square.bin.
Json square_document() {
  return Json::parse(R"({
    "asset": {"version": "2.0"},
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 5}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}],
    "buffers": [{"uri": "square.bin", "byteLength": 48}]})");
}

std::string square_bytes() {
  std::string bytes;
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}) append(bytes, x);
  return bytes;
}

std::string load_square(const std::string&) {
  return square_bytes();
}

TEST(Gltf, StripsAndFansKeepTheirOrientation) {
  Json json = square_document();
  for (const int mode : {5, 6}) {
    json["meshes"][0]["primitives"][0]["mode"] = mode;
    const SurfaceMesh mesh = read(json, load_square);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    const Triangle second = mesh.triangles[1];
    EXPECT_EQ(second, mode == 5 ? (Triangle{1, 3, 2}) : (Triangle{0, 2, 3}));
  }
}

TEST(Gltf, TransformsOfParentsComeAfterThoseOfChildren) {
  Json json = square_document();
  json["scenes"] = {{{"nodes", {0}}}};
  json["nodes"] = {{{"children", {1}}, {"scale", {2, 2, 2}}, {"translation", {0, 0, 1}}},
                   {{"mesh", 0}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}}}};
  const SurfaceMesh mesh = read(json, load_square);
  EXPECT_EQ(mesh.positions[1], Vec3(10, 2, 1));  // x turned to y, moved by 5, doubled, lifted
}

TEST(Gltf, MirroredMeshesStillFaceOutwards) {
  Json json = square_document();
  json["nodes"] = {{{"mesh", 0}, {"scale", {-1, 1, 1}}}};
  const SurfaceMesh mesh = read(json, load_square);
  for (const Triangle& t : mesh.triangles) {
    const Vec3& p = mesh.positions[t[0]];
    EXPECT_GT((mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p).z(), 0);
  }
}

TEST(Gltf, OnlyTheDefaultSceneIsRead) {
  Json json = square_document();
  json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {7, 0, 0}}}};
  json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  json["scene"] = 1;
  const SurfaceMesh mesh = read(json, load_square);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions[0], Vec3(7, 0, 0));
}

TEST(Gltf, IndicesOfEveryTypeAreRead) {
  Json json = square_document();
  json["meshes"][0]["primitives"][0]["mode"] = 4;
  json["meshes"][0]["primitives"][0]["indices"] = 1;
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 12}});
  json["buffers"][0]["byteLength"] = 60;
  const auto read_with = [&](int type, auto sample) {
    // clang 14 leaks a braced list in a generic lambda.
    Json& accessor = json["accessors"][1];
    accessor = Json::object();
    accessor["bufferView"] = 1;
    accessor["componentType"] = type;
    accessor["count"] = 3;
    accessor["type"] = "SCALAR";
    return read(json,
                [&](const std::string&) {
                  std::string bytes = square_bytes();
                  for (const int i : {2, 1, 3}) append(bytes, static_cast<decltype(sample)>(i));
                  bytes.resize(60, '\0');
                  return bytes;
                })
        .triangles[0];
  };
  EXPECT_EQ(read_with(5121, std::uint8_t{}), (Triangle{2, 1, 3}));
  EXPECT_EQ(read_with(5123, std::uint16_t{}), (Triangle{2, 1, 3}));
  EXPECT_EQ(read_with(5125, std::uint32_t{}), (Triangle{2, 1, 3}));
}

TEST(Gltf, InterleavedAttributesAndDataUrisAreRead) {
  Json json = square_document();
  json["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}}}};
  json["accessors"][0]["count"] = 3;
  json["bufferViews"][0]["byteStride"] = 4;  // too small: positions would overlap
  json["buffers"][0]["uri"] =
      "data:application/octet-stream;base64,"
      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAAAA";
  message_of([&] { read(json); });
  json["bufferViews"][0]["byteStride"] = 16;
  const SurfaceMesh mesh = read(json);
  EXPECT_EQ(mesh.positions[1], Vec3(0, 0, 0));
  EXPECT_EQ(mesh.positions[2], Vec3(0, 1, 1));
}

TEST(Gltf, CompressedDataAreNamedUnlessACopyStandsBesideThem) {
  Json json = square_document();
  json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = Json::object();
  EXPECT_EQ(read(json, load_square).triangles.size(), 2u);
  json["accessors"][0].erase("bufferView");
  EXPECT_NE(message_of([&] { read(json); }).find("Draco"), std::string::npos);
  json = square_document();
  json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = Json::object();
  EXPECT_EQ(read(json, load_square).triangles.size(), 2u);
  json["buffers"][0].erase("uri");
  json["buffers"][0]["extensions"]["EXT_meshopt_compression"]["fallback"] = true;
  EXPECT_NE(message_of([&] { read(json); }).find("meshopt"), std::string::npos);
}

TEST(Gltf, BuffersComeOnlyFromTheModelsFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "model/data");
  write_file(folder / "secret.bin", square_bytes());
  write_file(folder / "model/data/my square.bin", square_bytes());
  std::filesystem::create_symlink("../secret.bin", folder / "model/link.bin");
  const Context context;
  const FileLoader loader = load_from_folder(folder / "model", context);
  EXPECT_EQ(loader("data/my%20square.bin"), square_bytes());
  const std::string outside = (folder / "secret.bin").string();
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("data/../../secret.bin"),
        std::string("%2e%2e/secret.bin"), outside, "file://" + outside, std::string("link.bin"),
        std::string("http://example.org/a.bin"), std::string("..\\secret.bin"), std::string("data"),
        std::string("missing.bin"), std::string("a\0b", 3)}) {
    message_of([&] { loader(uri); });
  }
}

TEST(Gltf, WhatIsWrittenAsGlbReadsBackInSinglePrecision) {
  const SurfaceMesh mesh = rich_mesh();
  const SurfaceMesh back = read_mesh(format_mesh(mesh, "glb"), "a.glb").mesh;
  // Primitives gather the faces of a material, so put the original in that order too.
  SurfaceMesh sorted = mesh;
  std::size_t at = 0;
  for (const std::int32_t m : {0, 1}) {
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      if (mesh.face_materials[f] != m) continue;
      sorted.triangles[at] = mesh.triangles[f];
      sorted.face_materials[at] = m;
      for (std::size_t i = 0; i < 3; ++i) {
        sorted.corner_uvs[3 * at + i] = mesh.corner_uvs[3 * f + i];
        sorted.corner_normals[3 * at + i] = mesh.corner_normals[3 * f + i];
      }
      ++at;
    }
  }
  expect_same_corners(sorted, back, 2e-7);
  expect_same_materials(sorted, back);
  expect_same_at_corners(sorted, back, "crack_time", 1e-7);
  expect_same_at_corners(sorted, back, "displacement", 1e-7);
}

TEST(Gltf, NormalsWithoutDirectionAreNotWritten) {
  SurfaceMesh mesh = rich_mesh();
  mesh.corner_normals[0].setZero();
  const SurfaceMesh back = read_mesh(format_mesh(mesh, "glb"), "a.glb").mesh;
  for (const Vec3& n : back.corner_normals) EXPECT_NEAR(n.norm(), 1, 1e-6);
}

TEST(Gltf, CoordinatesBeyondFloatAreRefused) {
  SurfaceMesh mesh = rich_mesh();
  mesh.positions[0].x() = 1e39;
  message_of([&] { format_mesh(mesh, "glb"); }, ErrorKind::request);
}

}  // namespace
}  // namespace craze
