#include "craze/job/graph_from_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "craze/error.h"
#include "craze/products/statistics/null_models/null_models.h"

namespace craze {
namespace {

TEST(GraphFromFile, NullModelsAreNamedLikeShapes) {
  std::vector<std::string> said;
  EXPECT_EQ(graph_from_file("null:stit?cells=50&seed=3", said).edges.size(),
            null_graph(NullModel::stit, 50, 3).edges.size());
  EXPECT_EQ(graph_from_file("null:square", said).points.size(),
            null_graph(NullModel::square, 2000, 1).points.size());
  for (const char* wrong : {"null:", "null:pentagonal", "null:stit?", "null:stit?cells=",
                            "null:stit?cells=0", "null:stit?cells=-4", "null:stit?size=4",
                            "null:stit?cells=4&", "null:stit?cells=99999999999999999999"}) {
    EXPECT_THROW(graph_from_file(wrong, said), Error) << wrong;
  }
}

TEST(GraphFromFile, FilesHoldLinesOrACrackedMesh) {
  std::vector<std::string> said;
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir());
  const std::filesystem::path lines = folder / "graph_input_lines.obj";
  std::ofstream(lines) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n";
  EXPECT_EQ(graph_from_file(lines, said).edges.size(), 2u);
  const std::filesystem::path whole = folder / "graph_input_whole.obj";
  std::ofstream(whole) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
  EXPECT_THROW(graph_from_file(whole, said), Error) << "a mesh without cracks";
  EXPECT_TRUE(said.empty());
  // Two triangles along an edge of two vertices each, and a point, which no mesh keeps.
  std::ofstream(folder / "graph_input_cut.obj")
      << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\np 1\n";
  EXPECT_FALSE(graph_from_file(folder / "graph_input_cut.obj", said).edges.empty());
  EXPECT_EQ(said.size(), 1u);
}

}  // namespace
}  // namespace craze
