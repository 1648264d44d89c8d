#include "craze/io/lines/read_lines.h"

#include <gtest/gtest.h>

#include <cstring>

#include "craze/error.h"

namespace craze {
namespace {

std::optional<LineSet> parse(const std::string& text, const std::string& extension) {
  return read_lines(text, "test" + extension);
}

TEST(ReadLines, ObjPolylinesBecomeEdges) {
  const auto lines =
      parse("v 0 0 0\nv 1 0 0 # with a comment\nv 1 1 0\nl 1 2 3\nv 5 5 5\nl -1 1/7\n", ".obj");
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->points.size(), 4u);
  const std::vector<std::array<std::int32_t, 2>> expected{{0, 1}, {1, 2}, {3, 0}};
  EXPECT_EQ(lines->edges, expected);
}

TEST(ReadLines, PlyEdgesKeepTheirScalarsAndNormals) {
  const auto lines = parse(
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
      "property double z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "property int junction\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
      "property double time\nend_header\n0 0 0 0 0 1 3\n1 2 3 0 1 0 1\n1 0 0.25\n",
      ".ply");
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->points[1], Vec3(1, 2, 3));
  EXPECT_EQ(lines->edges[0], (std::array<std::int32_t, 2>{1, 0}));
  const Attribute* time = find_attribute(lines->edge_attributes, "time");
  ASSERT_TRUE(time);
  EXPECT_EQ(time->values, std::vector<double>{0.25});
  const Attribute* normal = find_attribute(lines->point_attributes, "normal");
  ASSERT_TRUE(normal);
  EXPECT_EQ(normal->values, (std::vector<double>{0, 0, 1, 0, 1, 0}));
  EXPECT_TRUE(find_attribute(lines->point_attributes, "junction"));
}

TEST(ReadLines, BinaryPlyIsReadToo) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n"
      "property float y\nproperty float z\nelement edge 1\nproperty int vertex1\n"
      "property int vertex2\nend_header\n";
  const float xyz[6] = {0, 0, 0, 1, 2, 3};
  const std::int32_t ends[2] = {0, 1};
  text.append(reinterpret_cast<const char*>(xyz), sizeof xyz);
  text.append(reinterpret_cast<const char*>(ends), sizeof ends);
  const auto lines = parse(text, ".ply");
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->points[1], Vec3(1, 2, 3));
  text.pop_back();
  EXPECT_THROW(parse(text, ".ply"), Error) << "one byte short";
}

TEST(ReadLines, JsonHoldsPointsEdgesAndAttributes) {
  const auto lines = parse(
      R"({"points": [[0, 0], [1, 0, 2.5]], "edges": [[0, 1]],
          "point_attributes": {"normal": [[0, 0, 1], [0, 1, 0]]},
          "edge_attributes": {"time": [0.5]}})",
      ".json");
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->points[1], Vec3(1, 0, 2.5));
  EXPECT_EQ(find_attribute(lines->edge_attributes, "time")->values[0], 0.5);
  EXPECT_EQ(find_attribute(lines->point_attributes, "normal")->components, 3);
}

TEST(ReadLines, AMeshHoldsNoLines) {
  EXPECT_FALSE(parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ".obj"));
  EXPECT_FALSE(parse("solid\n", ".stl"));
  EXPECT_FALSE(
      parse("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
            "property float y\nproperty float z\nend_header\n0 0 0\n",
            ".ply"));
}

TEST(ReadLines, WhatIsBrokenIsRefused) {
  const std::pair<const char*, const char*> broken[] = {
      {"v 0 0 0\nl 1 2\n", ".obj"},
      {"v 0 0 0\nl 1 0\n", ".obj"},
      {"v 0 0 0\nl 1 -9\n", ".obj"},
      {"v 0 0 0\nl 1 99999999999999999999\n", ".obj"},
      {"v 0 0\nl 1 1\n", ".obj"},
      {"{", ".json"},
      {"[]", ".json"},
      {R"({"points": [], "edges": [[0, 1]]})", ".json"},
      {R"({"points": [[0, 0]], "edges": [[0, -1]]})", ".json"},
      {R"({"points": [[0, 0]], "edges": [[0, 0.5]]})", ".json"},
      {R"({"points": [[0]], "edges": [[0, 0]]})", ".json"},
      {R"({"points": [["a", 1]], "edges": [[0, 0]]})", ".json"},
      {R"({"points": 3, "edges": []})", ".json"},
      {R"({"points": [[0, 0]], "edges": [[0, 0]], "edge_attributes": {"time": []}})", ".json"},
      {R"({"points": [[0, 0]], "edges": [[0, 0]], "edge_attributes": 3})", ".json"},
      {"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
       "property float z\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
       "end_header\n0 0 0\n0 1\n",
       ".ply"},
      {"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
       "property float z\nelement edge 1\nproperty int a\nend_header\n0 0 0\n0\n",
       ".ply"},
      {"ply\nformat ascii 1.0\nelement edge 4000000000\nproperty int vertex1\n"
       "property int vertex2\nend_header\n",
       ".ply"},
  };
  for (const auto& [text, extension] : broken) {
    EXPECT_THROW(parse(text, extension), Error) << text;
  }
}

}  // namespace
}  // namespace craze
