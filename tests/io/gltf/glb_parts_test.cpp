// What only GLB can hold: parts that move.
#include <fstream>
#include <nlohmann/json.hpp>

#include "craze/io/bytes/byte_order.h"
#include "craze/io/gltf/gltf.h"
#include "craze/mesh/mesh_parts.h"
#include "craze/mesh/morph_animation.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

using Json = nlohmann::json;

/// A GLB file taken apart, enough to play it.
class Played {
 public:
  explicit Played(const std::string& bytes) : bytes_(bytes) {
    const auto length = load<std::uint32_t>(bytes.data() + 12);
    json = Json::parse(bytes.substr(20, length));
    bin_ = 28 + length;
  }

  std::vector<Vec3> vectors(const Json& accessor_index) const {
    const Json& accessor = json["accessors"][accessor_index.get<std::size_t>()];
    std::vector<Vec3> result(accessor["count"].get<std::size_t>(), Vec3::Zero());
    if (accessor.contains("bufferView")) {
      for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = vector(accessor["bufferView"], i);
      }
    }
    if (!accessor.contains("sparse")) return result;
    const Json& sparse = accessor["sparse"];
    for (std::size_t i = 0; i < sparse["count"].get<std::size_t>(); ++i) {
      const auto at = load<std::uint32_t>(view(sparse["indices"]["bufferView"]) + 4 * i);
      result[at] = vector(sparse["values"]["bufferView"], i);
    }
    return result;
  }
  std::vector<float> floats(const Json& accessor_index) const {
    const Json& accessor = json["accessors"][accessor_index.get<std::size_t>()];
    std::vector<float> result;
    for (std::size_t i = 0; i < accessor["count"].get<std::size_t>(); ++i) {
      result.push_back(load<float>(view(accessor["bufferView"]) + 4 * i));
    }
    return result;
  }
  /// The vertices of a mesh, in the world, at a key of the animation.
  std::vector<Vec3> at_key(std::size_t node, std::size_t key) const {
    const Json& n = json["nodes"][node];
    const Json& primitive = json["meshes"][n["mesh"].get<std::size_t>()]["primitives"][0];
    std::vector<Vec3> p = vectors(primitive["attributes"]["POSITION"]);
    const Json& sampler = json["animations"][0]["samplers"][0];
    const std::vector<float> weights = floats(sampler["output"]);
    const std::size_t targets = primitive["targets"].size();
    for (std::size_t k = 0; k < targets; ++k) {
      const std::vector<Vec3> shift = vectors(primitive["targets"][k]["POSITION"]);
      for (std::size_t v = 0; v < p.size(); ++v) p[v] += weights[targets * key + k] * shift[v];
    }
    if (!n.contains("translation")) return p;
    for (Vec3& x : p) {
      for (int k = 0; k < 3; ++k) x[k] += n["translation"][k].get<double>();
    }
    return p;
  }

  Json json;

 private:
  const char* view(const Json& index) const {
    const Json& v = json["bufferViews"][index.get<std::size_t>()];
    return bytes_.data() + bin_ + v["byteOffset"].get<std::size_t>();
  }
  Vec3 vector(const Json& index, std::size_t i) const {
    const char* at = view(index) + 12 * i;
    return {load<float>(at), load<float>(at + 4), load<float>(at + 8)};
  }

  const std::string& bytes_;
  std::size_t bin_;
};

/// Vertices 1 and 4 move in the first stage, 4 and 5 in the third, none in the second.
MorphAnimation three_stages() {
  MorphAnimation animation;
  animation.seconds = 3;
  animation.stages.resize(3);
  animation.stages[0] = {{1, 4}, {Vec3(0.5, 0, 0), Vec3(0, 0.25, 0)}};
  animation.stages[2] = {{4, 5}, {Vec3(0, 0, 1), Vec3(1, 1, 1)}};
  return animation;
}

TEST(GlbAnimation, GoesStageByStageToTheMeshAsItIs) {
  const SurfaceMesh mesh = rich_mesh(4);
  const MorphAnimation animation = three_stages();
  const std::string bytes = format_mesh(mesh, "glb", {.animation = &animation});
  const Played played(bytes);
  const std::vector<float> keys =
      played.floats(played.json["animations"][0]["samplers"][0]["input"]);
  ASSERT_EQ(keys.size(), 6u) << "a wait, four ends of stages, a wait";
  EXPECT_EQ(keys[4] - keys[1], 3);
  std::vector<Vec3> expected = mesh.positions;
  const auto expect_key = [&](std::size_t key) {
    // Copies at seams come after the vertices of the mesh.
    const std::vector<Vec3> p = played.at_key(0, key);
    for (std::size_t v = 0; v < expected.size(); ++v) {
      EXPECT_LE((p[v] - expected[v]).norm(), 1e-6) << "vertex " << v << " at key " << key;
    }
  };
  expect_key(5);
  expect_key(4);
  expected[4] -= Vec3(0, 0, 1);
  expected[5] -= Vec3(1, 1, 1);
  expect_key(3);
  expect_key(2);
  expected[1] -= Vec3(0.5, 0, 0);
  expected[4] -= Vec3(0, 0.25, 0);
  expect_key(1);
  expect_key(0);
}

TEST(GlbAnimation, SeamsDoNotOpenOnTheWay) {
  const SurfaceMesh mesh = rich_mesh(4);
  const MorphAnimation animation = three_stages();
  const std::string bytes = format_mesh(mesh, "glb", {.animation = &animation});
  const Played played(bytes);
  const std::vector<Vec3> end = played.at_key(0, 5), start = played.at_key(0, 0);
  ASSERT_GT(end.size(), mesh.positions.size()) << "there are copies";
  for (std::size_t a = 0; a < end.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (end[a] != end[b]) continue;
      EXPECT_EQ(start[a], start[b]);
    }
  }
}

/// One part per square of the strip.
SurfaceMesh four_pieces() {
  SurfaceMesh mesh = rich_mesh(4);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    mesh.face_attributes[0].values[f] = static_cast<double>(3 - f / 2);
  }
  return mesh;
}

TEST(GlbObjects, PartsStayWhereTheyAreAndMeetToTheLastBit) {
  const SurfaceMesh mesh = four_pieces();
  const std::string bytes = format_mesh(mesh, "glb", {.objects = "fragment"});
  const SurfaceMesh read = read_mesh(bytes, "a.glb").mesh;
  EXPECT_EQ(read.triangles.size(), mesh.triangles.size());
  std::vector<Vec3> corners, places;
  for (const Triangle& t : read.triangles) {
    for (const std::int32_t v : t) corners.push_back(read.positions[v]);
  }
  for (const Vec3& p : mesh.positions) {
    std::vector<Vec3> there;
    for (const Vec3& q : corners) {
      if ((q - p).norm() < 1e-6) there.push_back(q);
    }
    ASSERT_FALSE(there.empty());
    for (const Vec3& q : there) EXPECT_EQ(q, there.front());
  }
}

TEST(GlbObjects, EachPartMovesWithItsOwnShareOfTheAnimation) {
  const SurfaceMesh mesh = four_pieces();
  const MorphAnimation animation = three_stages();
  const std::string bytes =
      format_mesh(mesh, "glb", {.objects = "fragment", .animation = &animation});
  const Played played(bytes);
  ASSERT_EQ(played.json["nodes"].size(), 4u);
  EXPECT_EQ(played.json["animations"][0]["channels"].size(), 4u);
  const std::vector<MeshPart> parts = mesh_parts(mesh, "fragment");
  for (std::size_t node = 0; node < 4; ++node) {
    EXPECT_EQ(played.json["nodes"][node]["name"], parts[node].name);
    const ExtractedPart part = extract_part(mesh, parts[node].faces);
    const std::vector<Vec3> start = played.at_key(node, 0);
    for (std::size_t v = 0; v < part.vertices.size(); ++v) {
      Vec3 expected = mesh.positions[part.vertices[v]];
      for (const MorphStage& stage : animation.stages) {
        for (std::size_t i = 0; i < stage.vertices.size(); ++i) {
          if (stage.vertices[i] == part.vertices[v]) expected -= stage.shifts[i];
        }
      }
      EXPECT_LE((start[v] - expected).norm(), 1e-6);
    }
  }
}

TEST(MeshParts, APartHasAllThatTheWholeHas) {
  const SurfaceMesh mesh = four_pieces();
  const ExtractedPart part = extract_part(mesh, {2, 3});
  EXPECT_EQ(part.mesh.positions.size(), 4u);
  for (std::size_t c = 0; c < 6; ++c) {
    const std::int32_t v = part.mesh.triangles[c / 3][c % 3];
    const std::size_t whole = 6 + c;
    const std::int32_t w = mesh.triangles[whole / 3][whole % 3];
    EXPECT_EQ(part.vertices[v], w);
    EXPECT_EQ(part.mesh.positions[v], mesh.positions[w]);
    EXPECT_EQ(part.mesh.vertex_colors[v], mesh.vertex_colors[w]);
    EXPECT_EQ(part.mesh.corner_uvs[c], mesh.corner_uvs[whole]);
    EXPECT_EQ(part.mesh.corner_normals[c], mesh.corner_normals[whole]);
    EXPECT_EQ(part.mesh.vertex_attributes[1].values[3 * v + 1],
              mesh.vertex_attributes[1].values[3 * w + 1]);
  }
  EXPECT_EQ(part.mesh.face_materials, (std::vector<std::int32_t>{1, 1}));
}

TEST(MeshParts, NeedANumberPerFace) {
  const SurfaceMesh mesh = rich_mesh(4);
  EXPECT_NE(message_of([&] { mesh_parts(mesh, "piece"); }, ErrorKind::request).find("piece"),
            std::string::npos);
}

}  // namespace
}  // namespace craze
