#include "craze/output/named_nodes.h"

#include <gtest/gtest.h>

#include "craze/read_mesh.h"

namespace craze {
namespace {

using Names = std::vector<std::string>;

/// where.nodes, spelt out for a file.
Names spelt(const MeshFile& file, Names patterns) {
  Recipe recipe;
  recipe.simulation.where.nodes = std::move(patterns);
  return with_named_nodes(recipe, file.mesh, file.scene.get()).simulation.where.nodes;
}

TEST(NamedNodes, AnObjectOfAnObjFileStandsForItsGroups) {
  const MeshFile file = read_mesh(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\no A\nf 1 2 3\ng right\nf 1 2 3\ng left\nf 1 2 3\no B\n"
      "g right\nf 1 2 3\n",
      "a.obj");
  EXPECT_EQ(spelt(file, {"A"}), (Names{"A/right", "A/left", "A"}));
  EXPECT_EQ(spelt(file, {"right"}), (Names{"A/right", "B/right"}));
  EXPECT_EQ(spelt(file, {"A/left"}), (Names{"A/left"}));
  EXPECT_EQ(spelt(file, {"nothing"}), (Names{"nothing"})) << "for the engine to say";
}

TEST(NamedNodes, ANodeStandsForAllBelowItAndAMeshForWhereItIsShown) {
  const MeshFile file = read_mesh(
      R"({"asset":{"version":"2.0"},"nodes":[{"name":"car","children":[1,2]},
      {"name":"wheel","mesh":0},{"children":[3]},{"mesh":0}],
      "meshes":[{"name":"rim","primitives":[{"attributes":{"POSITION":0}}]}],
      "accessors":[{"componentType":5126,"count":3,"type":"VEC3"}]})",
      "a.gltf");
  ASSERT_EQ(file.mesh.object_names, (Names{"wheel", "node_3"}));
  EXPECT_EQ(spelt(file, {"car"}), (Names{"wheel", "node_3"}));
  EXPECT_EQ(spelt(file, {"rim"}), (Names{"wheel", "node_3"}));
  EXPECT_EQ(spelt(file, {"wheel"}), (Names{"wheel"}));
}

TEST(NamedNodes, WithoutASceneNothingChanges) {
  EXPECT_EQ(spelt(MeshFile{}, {"car"}), (Names{"car"}));
}

}  // namespace
}  // namespace craze
