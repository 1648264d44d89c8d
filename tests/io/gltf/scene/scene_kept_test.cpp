// A glTF scene that comes back with its surface cracked.
#include "io/gltf/scene/truck.h"

#include <gtest/gtest.h>

#include "io/io_test_tools.h"

#include "craze/mesh/morph_animation.h"

#include <set>

namespace craze {
namespace {

/// All accessors that a primitive names hold the same bytes in both files, by the same description.
void expect_same_primitive(const SceneFile& a, const Json& in_a, const SceneFile& b,
                           const Json& in_b) {
  const auto expect_same = [&](const Json& x, const Json& y) {
    Json p = a.json["accessors"][x.get<std::size_t>()],
         q = b.json["accessors"][y.get<std::size_t>()];
    for (Json* accessor : {&p, &q}) accessor->erase("bufferView");
    EXPECT_EQ(p, q);
    EXPECT_EQ(a.elements(x), b.elements(y));
  };
  ASSERT_EQ(in_a["attributes"].size(), in_b["attributes"].size());
  for (const auto& [name, accessor] : in_a["attributes"].items()) {
    expect_same(accessor, in_b["attributes"][name]);
  }
  expect_same(in_a["indices"], in_b["indices"]);
  EXPECT_EQ(in_a.value("material", -1), in_b.value("material", -1));
}

TEST(SceneKept, WhatNothingCutsIsTheDocumentAndTheBytesThatItWas) {
  const SceneFile before = truck();
  const MeshFile file = read(before);
  ASSERT_NE(file.scene, nullptr);
  EXPECT_TRUE(file.warnings.empty());
  const SceneFile after = HandCut(file.mesh).write(file);
  Json expected = before.json;
  expected["buffers"][0]["byteLength"] = before.bin.size();
  EXPECT_EQ(after.json, expected);
  EXPECT_EQ(after.bin.substr(0, before.bin.size()), before.bin);
}

TEST(SceneKept, WhatIsNotAsGltfWantsItIsNamedAndTheSurfaceIsRead) {
  SceneFile nameless = truck(), aimless = truck(), pictureless = truck();
  nameless.json["materials"][0]["name"] = 5;
  aimless.json["animations"][0]["channels"][0].erase("target");
  pictureless.json["images"][0] = {{"uri", "../../else/where.png"}};
  for (const SceneFile* file : {&nameless, &aimless}) {
    const MeshFile read_back = read(*file);
    EXPECT_EQ(read_back.scene, nullptr);
    EXPECT_EQ(read_back.warnings.size(), 1u);
    EXPECT_EQ(read_back.mesh.triangles.size(), 10u);
  }
  const MeshFile without = read(pictureless);
  ASSERT_NE(without.scene, nullptr);
  EXPECT_EQ(without.warnings.size(), 1u);
}

TEST(SceneKept, ACutChangesThePrimitiveItCutsAndNothingElse) {
  const SceneFile before = truck();
  const MeshFile file = read(before);
  HandCut cut(file.mesh);
  cut.cut(body);
  const SceneFile after = cut.write(file);
  for (const char* list : {"cameras", "images", "samplers", "textures", "skins", "scenes"}) {
    EXPECT_EQ(before.json[list], after.json[list]) << list;
  }
  EXPECT_EQ(before.json["extensions"], after.json["extensions"]);
  EXPECT_EQ(before.json["asset"], after.json["asset"]);
  EXPECT_EQ(before.view(before.json["images"][0]["bufferView"]),
            after.view(after.json["images"][0]["bufferView"]));
  for (std::size_t m = 0; m < 2; ++m)
    EXPECT_EQ(before.json["materials"][m], after.json["materials"][m]);
  for (std::size_t n = 2; n < before.json["nodes"].size(); ++n) {
    EXPECT_EQ(before.json["nodes"][n], after.json["nodes"][n]);
  }
  expect_same_primitive(before, before.primitive(0, 1), after, after.primitive(0, 1));
  for (std::size_t mesh : {1, 2}) {
    expect_same_primitive(before, before.primitive(mesh, 0), after, after.primitive(mesh, 0));
  }
  // Names come first as they were; what cracks add comes after them.
  for (const char* list : {"nodes", "meshes", "materials", "images", "animations", "skins"}) {
    std::vector<std::string> names = after.names(list);
    const std::vector<std::string> old = before.names(list);
    ASSERT_GE(names.size(), old.size());
    names.resize(old.size());
    EXPECT_EQ(names, old) << list;
  }
  const Json& animation = after.json["animations"][0];
  for (std::size_t s = 0; s < 2; ++s) {
    for (const char* end : {"input", "output"}) {
      EXPECT_EQ(before.elements(before.json["animations"][0]["samplers"][s][end]),
                after.elements(animation["samplers"][s][end]));
    }
  }
}

TEST(SceneKept, OldVerticesComeFirstWithTheirBytesAndNewOnesLieBetweenThem) {
  const SceneFile before = truck();
  const MeshFile file = read(before);
  HandCut cut(file.mesh);
  cut.cut(body);
  const SceneFile after = cut.write(file);
  const Json& old = before.primitive(0, 0)["attributes"];
  const Json& made = after.primitive(0, 0)["attributes"];
  for (const auto& [name, accessor] : old.items()) {
    const std::string first = before.elements(accessor), all = after.elements(made[name]);
    EXPECT_EQ(all.substr(0, first.size()), first) << name;
    EXPECT_EQ(all.size() * 4, first.size() * 7) << "two in the middle, one copy: " << name;
    const Json& described = after.json["accessors"][made[name].get<std::size_t>()];
    EXPECT_EQ(described["componentType"],
              before.json["accessors"][accessor.get<std::size_t>()]["componentType"]);
  }
  const std::vector<float> p = after.floats(made["POSITION"]);
  for (const std::size_t middle : {4, 5}) {
    EXPECT_EQ(std::vector<float>(p.begin() + 3 * middle, p.begin() + 3 * middle + 3),
              (std::vector<float>{0.5f, 0, 0}));
  }
  const std::vector<float> t = after.floats(made["TANGENT"]);
  EXPECT_EQ(std::vector<float>(t.begin() + 16, t.begin() + 20), (std::vector<float>{1, 0, 0, -1}));
  const std::string uv = after.elements(made["TEXCOORD_0"]);
  EXPECT_EQ(load<std::uint16_t>(uv.data() + 16), 32768);
  const std::vector<float> uv1 = after.floats(made["TEXCOORD_1"]);
  EXPECT_EQ(uv1[8], 1.5f);
  const std::string color = after.elements(made["COLOR_0"]);
  EXPECT_EQ(static_cast<unsigned char>(color[12]), 128) << "half of red";
  EXPECT_EQ(load<std::uint16_t>(after.elements(made["_PART"]).data() + 8), 7);
  // Faces keep the way they turn: (a, m, c) and (m, b, c).
  const std::string index = after.elements(after.primitive(0, 0)["indices"]);
  std::vector<int> indices;
  for (std::size_t i = 0; i < index.size(); i += 2) {
    indices.push_back(load<std::uint16_t>(index.data() + i));
  }
  EXPECT_EQ(indices, (std::vector<int>{0, 4, 2, 5, 1, 6, 0, 2, 3}));
}

TEST(SceneKept, TheCutSceneReadsBackAsTheCutMesh) {
  for (const std::int32_t face : {body, second_body + 1, left_wheel, banner, banner + 1}) {
    const MeshFile file = read(truck());
    HandCut cut(file.mesh);
    cut.cut(face);
    for (const std::int32_t v : cut.far_side()) cut.mesh.positions[v] += Vec3(0.1, 0.2, 0.3);
    const MeshFile back = read_mesh(format_mesh(cut.mesh, "glb", cut.options(file)), "a.glb");
    ASSERT_EQ(back.mesh.triangles.size(), cut.mesh.triangles.size());
    double furthest = 0;
    for (const Triangle& t : cut.mesh.triangles) {
      for (const std::int32_t v : t) {
        double nearest = 1e9;
        for (const Vec3& p : back.mesh.positions) {
          nearest = std::min(nearest, (p - cut.mesh.positions[v]).norm());
        }
        furthest = std::max(furthest, nearest);
      }
    }
    EXPECT_LT(furthest, 1e-5) << "face " << face << ", through its node or joints and morphs";
  }
}

TEST(SceneKept, AMeshThatTwoNodesShowIsDividedOnlyWhereItCracks) {
  const SceneFile before = truck();
  const MeshFile file = read(before);
  HandCut one(file.mesh);
  one.cut(left_wheel);
  const SceneFile after = one.write(file);
  EXPECT_EQ(after.json["nodes"][3]["mesh"], 1);
  expect_same_primitive(before, before.primitive(1, 0), after, after.primitive(1, 0));
  const std::size_t own = after.json["nodes"][2]["mesh"];
  EXPECT_NE(own, 1u);
  EXPECT_EQ(after.json["meshes"][own]["name"], "wheel");
  EXPECT_EQ(after.json["nodes"][2]["extras"], before.json["nodes"][2]["extras"]);

  HandCut both(file.mesh);
  both.cut(left_wheel);
  both.cut(right_wheel);
  const SceneFile divided = both.write(file);
  EXPECT_NE(divided.json["nodes"][2]["mesh"], divided.json["nodes"][3]["mesh"]);
  std::set<std::size_t> shown;
  for (const Json& node : divided.json["nodes"]) {
    if (node.contains("mesh")) shown.insert(node["mesh"].get<std::size_t>());
  }
  EXPECT_EQ(shown.size(), divided.json["meshes"].size()) << "no mesh is left that nothing shows";
}

TEST(SceneKept, JointsOfNewVerticesAreWeightedAndSumToOne) {
  const MeshFile file = read(truck());
  HandCut cut(file.mesh);
  cut.cut(banner);
  const SceneFile after = cut.write(file);
  const Json& made = after.primitive(2, 0);
  const std::string joints = after.elements(made["attributes"]["JOINTS_0"]);
  const std::vector<float> weights = after.floats(made["attributes"]["WEIGHTS_0"]);
  // Between (¾, ¼) of joints 0 and 1 and joint 1 alone.
  std::map<int, float> at_middle;
  for (std::size_t k = 16; k < 20; ++k) at_middle[joints[k]] += weights[k];
  EXPECT_FLOAT_EQ(at_middle[0], 0.375f);
  EXPECT_FLOAT_EQ(at_middle[1], 0.625f);
  for (std::size_t k = 18; k < 20; ++k) EXPECT_EQ(joints[k], 0) << "of no weight, no joint";
  const std::vector<float> morph = after.floats(made["targets"][0]["POSITION"]);
  EXPECT_EQ(morph[3 * 4 + 2], 1.0f) << "half of the shift by 2";
  EXPECT_EQ(after.json["meshes"][2]["weights"], Json({0.5}));
}

TEST(SceneKept, MatricesOfVerticesStayMatrices) {
  SceneFile before = truck();
  for (const auto& [type, numbers] : {std::pair{"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}) {
    std::vector<float> values;
    for (int i = 0; i < 4 * numbers; ++i) values.push_back(static_cast<float>(i / numbers));
    before.json["meshes"][0]["primitives"][0]["attributes"][std::string("_") + type] =
        before.add(values, type, 5126, static_cast<std::size_t>(numbers));
  }
  const MeshFile file = read(before);
  HandCut cut(file.mesh);
  cut.cut(body);
  const SceneFile after = cut.write(file);
  for (const std::string type : {"MAT2", "MAT3", "MAT4"}) {
    const Json& accessor = after.primitive(0, 0)["attributes"]["_" + type];
    EXPECT_EQ(after.json["accessors"][accessor.get<std::size_t>()]["type"], type);
    const std::vector<float> values = after.floats(accessor);
    const std::size_t numbers = values.size() / 7;
    EXPECT_EQ(values[numbers], 1) << "the second corner's";
    EXPECT_EQ(values[4 * numbers], 0.5f) << "between the first and the second";
  }
  // Columns of bytes begin at multiples of four.
  SceneFile narrow = truck();
  narrow.json["meshes"][0]["primitives"][0]["attributes"]["_M"] =
      narrow.add<std::uint8_t>(std::vector<std::uint8_t>(16, 0), "MAT2", 5121, 4);
  EXPECT_NE(message_of([&] { read(narrow); }).find("MAT2"), std::string::npos);
}

TEST(SceneKept, WallsAreAPrimitiveOfThePartsMeshWithAMaterialOfTheirOwn) {
  const SceneFile before = truck();
  const MeshFile file = read(before);
  HandCut cut(file.mesh);
  cut.cut(body);
  cut.crack_edges.clear();
  cut.wall(body, 1, 2, 0.25);
  const SceneFile after = cut.write(file);
  ASSERT_EQ(after.json["meshes"][0]["primitives"].size(), 3u);
  const Json& wall = after.primitive(0, 2);
  EXPECT_EQ(after.json["materials"][wall["material"].get<std::size_t>()]["name"], "crack_wall_2")
      << "the file has a crack_wall of its own";
  // 0.25 down in a scene that is scaled by 2.
  const std::vector<float> p = after.floats(wall["attributes"]["POSITION"]);
  float lowest = 0;
  for (std::size_t i = 2; i < p.size(); i += 3) lowest = std::min(lowest, p[i]);
  EXPECT_FLOAT_EQ(lowest, -0.125f);
  EXPECT_EQ(after.json["meshes"].size(), before.json["meshes"].size());
}

TEST(SceneKept, LinesLieBelowThePartsNodeAndMoveWithIt) {
  const SceneFile before = truck();
  const MeshFile file = read(before);
  HandCut cut(file.mesh);
  cut.cut(body);
  cut.cut(banner);
  const SceneFile after = cut.write(file);
  const std::size_t nodes = before.json["nodes"].size();
  ASSERT_EQ(after.json["nodes"].size(), nodes + 2);
  EXPECT_EQ(after.json["nodes"][1]["children"], Json({nodes}));
  const Json& lines = after.json["nodes"][nodes];
  const Json& drawn = after.primitive(lines["mesh"], 0);
  EXPECT_EQ(drawn["mode"], 1);
  const Json& material = after.json["materials"][drawn["material"].get<std::size_t>()];
  EXPECT_EQ(material["name"], "crack_line");
  EXPECT_TRUE(material["extensions"].contains("KHR_materials_unlit"));
  const std::vector<float> p = after.floats(drawn["attributes"]["POSITION"]);
  ASSERT_EQ(p.size(), 6u);
  for (const std::size_t z : {2, 5}) {
    EXPECT_GT(p[z], 0) << "off the surface";
    EXPECT_LT(p[z], 0.01f);
  }
  // Those of the flag follow its joints and its morph target, animated or not.
  const Json& waving = after.json["nodes"][nodes + 1];
  EXPECT_EQ(waving["skin"], 0);
  const Json& flag = after.primitive(waving["mesh"], 0);
  EXPECT_TRUE(flag["attributes"].contains("JOINTS_0"));
  EXPECT_EQ(flag["mode"], 4) << "viewers move triangles by joints, and few of them lines";
  EXPECT_EQ(after.floats(flag["attributes"]["POSITION"]).size() % 12, 0u) << "a band an edge";
  EXPECT_EQ(flag["extras"]["crack_lines"], true) << "by which readers of ours leave it out";
  EXPECT_EQ(flag["targets"].size(), 1u);
  EXPECT_EQ(after.json["animations"][0]["channels"].size(), 3u);
  EXPECT_EQ(after.json["animations"][0]["channels"][2]["target"]["node"], nodes + 1);
}

/// Where the channels of an animation point to.
std::vector<std::string> pointers(const Json& animation) {
  std::vector<std::string> all;
  for (const Json& channel : animation["channels"]) {
    const Json::json_pointer at("/target/extensions/KHR_animation_pointer/pointer");
    all.push_back(channel.contains(at) ? channel[at].get<std::string>() : "");
  }
  return all;
}

TEST(SceneKept, WeightsThatAPointerMovesMoveThoseOfLinesAndPiecesToo) {
  SceneFile before = truck();
  Json& channels = before.json["animations"][0]["channels"];
  const auto point = [&](const std::string& at) {
    Json channel = channels[1];
    channel["target"] = {{"path", "pointer"}};
    channel["target"]["extensions"]["KHR_animation_pointer"]["pointer"] = at;
    channels.push_back(std::move(channel));
  };
  for (const char* at : {"/nodes/5/weights", "/nodes/5/weights/0", "/nodes/5/scale",
                         "/nodes/5/weightsome", "/materials/0/alphaCutoff", "/nodes/x"}) {
    point(at);
  }
  const std::vector<std::string> old = pointers(before.json["animations"][0]);
  const MeshFile file = read(before);
  HandCut cut(file.mesh);
  cut.cut(banner);
  const SceneFile after = cut.write(file);
  const std::string lines = "/nodes/" + std::to_string(before.json["nodes"].size());
  std::vector<std::string> expected = old;
  expected.insert(expected.end(), {"", lines + "/weights", lines + "/weights/0"});
  EXPECT_EQ(pointers(after.json["animations"][0]), expected);
  // On another surface nothing has weights.
  const SceneFile other(format_mesh(file.mesh, "glb", {.scene = file.scene}));
  ASSERT_TRUE(other.json.contains("animations"));
  EXPECT_EQ(pointers(other.json["animations"][0]),
            (std::vector<std::string>{"", "/nodes/5/scale", "/nodes/5/weightsome",
                                      "/materials/0/alphaCutoff", "/nodes/x"}));
}

TEST(SceneKept, GrowthOfAnotherSurfacePlaysOnItsNodes) {
  const MeshFile file = read(truck());
  HandCut cut(file.mesh);
  const std::int32_t moved = file.mesh.triangles[second_body][0];
  const Vec3 shift(0.5, 0.25, -0.125);
  const MorphAnimation growth{2, {{{moved}, {shift}}, {}}};
  MeshFileOptions options = cut.options(file);
  options.origin = nullptr;
  options.animation = &growth;
  std::vector<std::string> told;
  options.warn = [&](const std::string& sentence) { told.push_back(sentence); };
  SceneFile after(format_mesh(cut.mesh, "glb", options));
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("skins"), std::string::npos) << told[0];
  EXPECT_EQ(after.names("nodes"), SceneFile(truck().bytes()).names("nodes"));
  EXPECT_EQ(after.names("animations").back(), "growth");
  EXPECT_GT(after.names("animations").size(), 1u) << "the nodes' own stay";
  const Json& channels = after.json["animations"].back()["channels"];
  EXPECT_EQ(channels.size(), 4u) << "chassis, two wheels, banner";
  // Rest is open; with the first stage still to come the vertex is where it was before.
  const auto positions = [](const SceneFile& scene) {
    return read_mesh(scene.bytes(), "a.glb").mesh.positions;
  };
  const std::vector<Vec3> open = positions(after);
  for (Json& mesh : after.json["meshes"]) mesh["weights"] = {1, 0};
  const std::vector<Vec3> before = positions(after);
  ASSERT_EQ(open.size(), before.size());
  int count = 0;
  for (std::size_t v = 0; v < open.size(); ++v) {
    if (open[v] == before[v]) continue;
    ++count;
    EXPECT_LT((open[v] - before[v] - shift).norm(), 1e-6);
    EXPECT_LT((open[v] - file.mesh.positions[moved]).norm(), 1e-6);
  }
  EXPECT_GT(count, 0);
}

TEST(SceneKept, TrianglesThatTheCutMeshLeavesOutStay) {
  const MeshFile file = read(truck());
  HandCut cut(file.mesh);
  cut.cut(body);
  // Drop the body's second triangle from the cut mesh.
  cut.mesh.triangles.erase(cut.mesh.triangles.begin() + 1);
  cut.origin.face.erase(cut.origin.face.begin() + 1);
  cut.origin.weights.erase(cut.origin.weights.begin() + 3, cut.origin.weights.begin() + 6);
  --cut.origin.wall_begin;
  const MeshFile back = read_mesh(format_mesh(cut.mesh, "glb", cut.options(file)), "a.glb");
  EXPECT_EQ(back.mesh.triangles.size(), file.mesh.triangles.size() + 1);
}

TEST(SceneKept, GrowthIsAddedToWhatMovesAlready) {
  const SceneFile before = truck();
  const MeshFile file = read(before);
  HandCut cut(file.mesh);
  cut.cut(body);
  cut.crack_edges.clear();
  const std::array<std::int32_t, 3> side = cut.far_side();
  for (const std::int32_t v : side) cut.mesh.positions[v].z() += 0.5;
  MorphAnimation growth{2, {{}, {}}};
  for (const std::int32_t v : std::set<std::int32_t>(side.begin(), side.end())) {
    growth.stages[1].vertices.push_back(v);
    growth.stages[1].shifts.emplace_back(0, 0, 0.5);
  }
  MeshFileOptions options = cut.options(file);
  options.animation = &growth;
  const SceneFile after(format_mesh(cut.mesh, "glb", options));
  EXPECT_EQ(after.names("animations"), (std::vector<std::string>{"drive", "growth"}));
  for (std::size_t p = 0; p < 2; ++p) {
    const Json& targets = after.primitive(0, p)["targets"];
    ASSERT_EQ(targets.size(), 2u) << "as many in each primitive of a mesh";
    for (const Json& target : targets) {
      EXPECT_TRUE(after.json["accessors"][target["POSITION"].get<std::size_t>()].contains("min"));
    }
  }
  // 0.5 in a scene that is scaled by 2; vertex 1 is one of those that move.
  const std::vector<float> back = after.floats(after.primitive(0, 0)["targets"][1]["POSITION"]);
  EXPECT_FLOAT_EQ(back[3 * 1 + 2], -0.25f);
  EXPECT_EQ(after.json["meshes"][0]["weights"], Json({0, 0}));
}

TEST(SceneKept, InstancesBecomeSingleWhereTheyCrack) {
  SceneFile before = truck();
  Json& node = before.json["nodes"][2];
  node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
      before.add<float>({0, 0, 0, 4, 0, 0, 8, 0, 0}, "VEC3", 5126, 3);
  before.json["extensionsUsed"].push_back("EXT_mesh_gpu_instancing");
  const MeshFile file = read(before);
  HandCut cut(file.mesh);
  cut.crack_edges.clear();
  cut.cut(left_wheel + 2);
  cut.crack_edges.clear();
  const SceneFile after = cut.write(file);
  const Json& left =
      after.json["nodes"][2]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"];
  EXPECT_EQ(after.floats(left), (std::vector<float>{0, 0, 0, 8, 0, 0}));
  const Json& single = after.json["nodes"].back();
  EXPECT_EQ(single["translation"], Json({4.0, 0.0, 0.0}));
  EXPECT_EQ(single["name"], "left wheel_1");
  EXPECT_NE(single["mesh"], 1);
  const MeshFile back = read_mesh(after.bytes(), "a.glb");
  EXPECT_EQ(back.mesh.triangles.size(), file.mesh.triangles.size() + 1);
}

}  // namespace
}  // namespace craze
