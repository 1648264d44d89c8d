// A glTF scene whose surface comes back in fragments, and growth beside targets of its own.
#include "io/gltf/scene/truck.h"

#include <gtest/gtest.h>

#include <set>

#include "craze/mesh/morph_animation.h"

namespace craze {
namespace {

/// A face cut in two, all else being a fragment per object.
struct Apart {
  MeshFile file = read(truck());
  HandCut cut{file.mesh};

  explicit Apart(std::int32_t face) {
    const std::vector<std::int32_t> object = file.mesh.face_objects;
    cut.cut(face);
    cut.crack_edges.clear();
    Attribute fragment{"fragment", 1, {}};
    for (const std::int32_t o : object) fragment.values.push_back(o);
    fragment.values.push_back(90);
    cut.mesh.face_attributes = {fragment};
  }
  SceneFile write(const MorphAnimation* growth = nullptr) const {
    MeshFileOptions options = cut.options(file);
    options.objects = "fragment";
    options.animation = growth;
    return SceneFile(format_mesh(cut.mesh, "glb", options));
  }
};

std::vector<std::string> names_of(const SceneFile& file, const Json& nodes) {
  std::vector<std::string> names;
  for (const Json& node : nodes) names.push_back(file.json["nodes"][node.get<int>()]["name"]);
  return names;
}

TEST(SceneApart, FragmentsAreNodesBelowThePartsNode) {
  const Apart apart(body);
  const SceneFile before = truck(), after = apart.write();
  const Json& chassis = after.json["nodes"][1];
  EXPECT_EQ(names_of(after, chassis["children"]),
            (std::vector<std::string>{"fragment_0", "fragment_90"}));
  EXPECT_FALSE(chassis.contains("mesh"));
  EXPECT_EQ(chassis["translation"], before.json["nodes"][1]["translation"]);
  EXPECT_EQ(after.json["nodes"][0], before.json["nodes"][0]);
  for (const char* list : {"materials", "cameras", "images", "textures", "skins", "extensions"}) {
    EXPECT_EQ(after.json[list], before.json[list]) << list;
  }
  const Json& whole = after.json["nodes"][chassis["children"][0].get<int>()];
  const Json& mesh = after.json["meshes"][whole["mesh"].get<int>()];
  EXPECT_EQ(mesh["name"], "body");
  EXPECT_EQ(mesh["extras"], 5);
  ASSERT_EQ(mesh["primitives"].size(), 2u);
  EXPECT_EQ(mesh["primitives"][0]["extras"]["kind"], "square");
  for (const char* name : {"TANGENT", "TEXCOORD_1", "COLOR_0", "_PART"}) {
    EXPECT_TRUE(mesh["primitives"][0]["attributes"].contains(name)) << name;
  }
}

TEST(SceneApart, EachFragmentHasItsOriginInItselfAndLiesWhereItWas) {
  const Apart apart(body);
  const SceneFile after = apart.write();
  const MeshFile back = read_mesh(after.bytes(), "a.glb");
  ASSERT_EQ(back.mesh.triangles.size(), apart.cut.mesh.triangles.size());
  for (const Vec3& p : apart.cut.mesh.positions) {
    double nearest = 1e9;
    for (const Vec3& q : back.mesh.positions) nearest = std::min(nearest, (p - q).norm());
    EXPECT_LT(nearest, 1e-5);
  }
  for (const Json& node : after.json["nodes"]) {
    if (!node.contains("mesh") || node.contains("skin")) continue;
    const Json& p = after.primitive(node["mesh"], 0)["attributes"]["POSITION"];
    const Json& accessor = after.json["accessors"][p.get<std::size_t>()];
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LE(accessor["min"][k], 0.0);
      EXPECT_GE(accessor["max"][k], 0.0);
    }
  }
}

TEST(SceneApart, WhatJointsPlaceStaysOnThemAndMovesAsItDid) {
  const Apart apart(banner);
  const SceneFile before = truck(), after = apart.write();
  const Json& top = after.json["scenes"][0]["nodes"];
  ASSERT_EQ(top.size(), before.json["scenes"][0]["nodes"].size() + 2);
  std::set<int> moved;
  for (std::size_t k = top.size() - 2; k < top.size(); ++k) {
    const Json& node = after.json["nodes"][top[k].get<int>()];
    EXPECT_EQ(node["skin"], 0);
    EXPECT_FALSE(node.contains("translation"));
    const Json& mesh = after.json["meshes"][node["mesh"].get<int>()];
    EXPECT_EQ(mesh["weights"], Json({0.5}));
    EXPECT_EQ(mesh["primitives"][0]["targets"].size(), 1u);
    EXPECT_TRUE(mesh["primitives"][0]["attributes"].contains("JOINTS_0"));
    moved.insert(top[k].get<int>());
  }
  std::set<int> heirs;
  for (const Json& channel : after.json["animations"][0]["channels"]) {
    if (channel["target"]["path"] == "weights") heirs.insert(channel["target"]["node"].get<int>());
  }
  EXPECT_EQ(heirs, moved) << "the node itself has no targets any more";
  EXPECT_FALSE(after.json["nodes"][5].contains("mesh"));
}

TEST(SceneApart, WallsGoWithTheirFragment) {
  Apart apart(body);
  const auto f = static_cast<std::int32_t>(apart.cut.mesh.triangles.size()) - 1;
  apart.cut.wall(f, 0, 1, 0.25);
  apart.cut.mesh.face_attributes[0].values.insert(apart.cut.mesh.face_attributes[0].values.end(), 2,
                                                  90);
  const SceneFile after = apart.write();
  const Json& piece = after.json["nodes"][after.json["nodes"][1]["children"][1].get<int>()];
  const Json& made = after.json["meshes"][piece["mesh"].get<int>()]["primitives"];
  ASSERT_EQ(made.size(), 2u);
  EXPECT_EQ(after.json["materials"][made[1]["material"].get<int>()]["name"], "crack_wall_2");
}

TEST(SceneApart, GrowthComesAfterTheTargetsOfAPart) {
  const SceneFile before = truck();
  const MeshFile file = read(before);
  for (const bool in_pieces : {false, true}) {
    HandCut cut(file.mesh);
    cut.cut(banner);
    cut.crack_edges.clear();
    cut.mesh.face_attributes = {{"fragment", 1, std::vector<double>(11, 0)}};
    const std::int32_t v = cut.far_side()[0];
    cut.mesh.positions[v].x() += 0.5;
    const MorphAnimation growth{2, {{{v}, {Vec3(0.5, 0, 0)}}, {{}, {}}}};
    MeshFileOptions options = cut.options(file);
    options.animation = &growth;
    if (in_pieces) options.objects = "fragment";
    std::vector<std::string> told;
    options.warn = [&](const std::string& sentence) { told.push_back(sentence); };
    const SceneFile after(format_mesh(cut.mesh, "glb", options));
    EXPECT_TRUE(told.empty());
    const Json& mesh = after.json["meshes"][2];
    EXPECT_EQ(mesh["weights"], Json({0.5, 0.0, 0.0}));
    const Json& targets = mesh["primitives"][0]["targets"];
    ASSERT_EQ(targets.size(), 3u);
    EXPECT_EQ(mesh["extras"]["targetNames"].size(), 3u);
    // Each animation says all three weights: the own one of the scene's, 0.5 of the growth's.
    const auto weights = [&](std::size_t animation) {
      for (const Json& channel : after.json["animations"][animation]["channels"]) {
        const Json& target = channel["target"];
        const Json& node = after.json["nodes"][target["node"].get<int>()];
        if (target["path"] != "weights" || node.value("mesh", -1) != 2) continue;
        const Json& sampler =
            after.json["animations"][animation]["samplers"][channel["sampler"].get<int>()];
        return after.floats(sampler["output"]);
      }
      return std::vector<float>{};
    };
    EXPECT_EQ(weights(0), (std::vector<float>{0, 0, 0, 1, 0, 0}));
    const std::vector<float> grown = weights(1);
    ASSERT_FALSE(grown.empty());
    for (std::size_t k = 0; k < grown.size(); k += 3) EXPECT_EQ(grown[k], 0.5f);
    EXPECT_EQ(std::vector<float>(grown.begin(), grown.begin() + 3),
              (std::vector<float>{0.5f, 1, 1}));
    EXPECT_EQ(std::vector<float>(grown.end() - 3, grown.end()), (std::vector<float>{0.5f, 0, 0}));
  }
}

TEST(SceneKept, NormalsOfBentFacesAreTheMeshs) {
  const SceneFile before = truck();
  const MeshFile file = read(before);
  HandCut cut(file.mesh);
  cut.cut(body);
  for (const std::int32_t v : cut.far_side()) cut.mesh.positions[v].z() += 0.5;
  const Vec3 tilted = Vec3(0.6, 0, 0.8);
  cut.mesh.corner_normals.assign(3 * cut.mesh.triangles.size(), Vec3::UnitZ());
  for (std::size_t c = cut.mesh.corner_normals.size() - 3; c < cut.mesh.corner_normals.size();
       ++c) {
    cut.mesh.corner_normals[c] = tilted;
  }
  MeshFileOptions options = cut.options(file);
  options.bent = true;
  const SceneFile after(format_mesh(cut.mesh, "glb", options));
  const MeshFile back = read_mesh(after.bytes(), "a.glb");
  int turned = 0;
  for (const Vec3& n : back.mesh.corner_normals) {
    const bool is_tilted = (n - tilted).norm() < 1e-6;
    EXPECT_TRUE(is_tilted || (n - Vec3::UnitZ()).norm() < 1e-6);
    turned += is_tilted;
  }
  EXPECT_EQ(turned, 3);
  const Json& made = after.primitive(0, 0)["attributes"];
  const std::vector<float> n = after.floats(made["NORMAL"]), t = after.floats(made["TANGENT"]);
  for (std::size_t v = 0; v < n.size() / 3; ++v) {
    EXPECT_NEAR(n[3 * v] * t[4 * v] + n[3 * v + 1] * t[4 * v + 1] + n[3 * v + 2] * t[4 * v + 2], 0,
                1e-6);
  }
  options.bent = false;
  const SceneFile kept(format_mesh(cut.mesh, "glb", options));
  for (const Vec3& normal : read_mesh(kept.bytes(), "a.glb").mesh.corner_normals) {
    EXPECT_NEAR(normal.z(), 1, 1e-6);
  }
}

}  // namespace
}  // namespace craze
