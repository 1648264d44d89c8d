#include "craze/io/lines/write_lines.h"

#include <nlohmann/json.hpp>

#include "craze/io/bytes/byte_order.h"
#include "craze/io/files/read_file.h"
#include "craze/io/ply/ply_header.h"
#include "craze/io/ply/ply_table.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

/// A T of four edges on a tilted plane, and a closed triangle beside it.
LineSet lines() {
  LineSet set;
  const auto place = [](double x, double y) { return Vec3(x, y, x / 3 + y / 7 + 2); };
  for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(2, 0), Vec2(1, 1), Vec2(1, 2), Vec2(5, 0),
                        Vec2(6, 0), Vec2(5, 1)}) {
    set.points.push_back(place(p.x(), p.y()));
  }
  set.edges = {{0, 1}, {1, 2}, {4, 3}, {3, 1}, {5, 6}, {6, 7}, {7, 5}};
  set.edge_attributes = {{"time", 1, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}}};
  set.point_attributes = {{"pull", 2, std::vector<double>(16, 0.25)}};
  return set;
}

TEST(Lines, ChainsUseEveryEdgeOnceAndBreakAtJunctions) {
  const LineSet set = lines();
  const auto chains = join_edges(set);
  EXPECT_EQ(chains,
            (std::vector<std::vector<std::int32_t>>{{0, 1}, {1, 2}, {1, 3, 4}, {5, 6, 7, 5}}));
}

TEST(Lines, PlyKeepsEverythingToTheLastBit) {
  LineSet set = lines();
  for (std::size_t i = 0; i < 2 * set.edges.size(); ++i) {
    set.uvs.emplace_back(static_cast<double>(i) / 3, 0.5);
  }
  const std::string bytes = format_lines_ply(set), name = "lines.ply";
  const PlyHeader header = parse_ply_header(bytes, name);
  const FileLoader no_files;
  const Context context;
  std::vector<std::string> said;
  std::shared_ptr<const SourceScene> scene;
  const MeshSource source{bytes, name, no_files, context, said, said, scene};
  PlyBody body(source, header);
  const auto points = body.read(header.elements[0]);
  const auto edges = body.read(header.elements[1]);
  ASSERT_EQ(header.elements[1].name, "edge");
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    EXPECT_EQ(points[2].values[i], set.points[i].z());
  }
  for (std::size_t e = 0; e < set.edges.size(); ++e) {
    EXPECT_EQ(edges[1].values[e], set.edges[e][1]);
    EXPECT_EQ(edges[4].values[e], set.uvs[2 * e + 1].x());
    EXPECT_EQ(edges[6].values[e], set.edge_attributes[0].values[e]);
  }
  EXPECT_EQ(header.elements[1].properties[4].name, "s2");
}

TEST(Lines, ObjJoinsEdges) {
  const std::string text = format_lines_obj(lines());
  EXPECT_NE(text.find("\nl 2 4 5\nl 6 7 8 6\n"), std::string::npos) << text;
}

TEST(Lines, JsonHoldsPointsEdgesAndAttributes) {
  const auto json = nlohmann::json::parse(format_lines_json(lines()));
  EXPECT_EQ(json["edges"][2], (nlohmann::json{4, 3}));
  EXPECT_EQ(json["points"][1][2].get<double>(), lines().points[1].z());
  EXPECT_EQ(json["edge_attributes"]["time"][3], 0.4);
  EXPECT_EQ(json["point_attributes"]["pull"][7], (nlohmann::json{0.25, 0.25}));
  EXPECT_FALSE(json.contains("uvs"));
  EXPECT_EQ(nlohmann::json::parse(format_lines_json({}))["edges"].size(), 0u);
}

TEST(Lines, SvgOfTheXyPlaneKeepsTheAxesAndTurnsYDown) {
  LineSet set;
  set.points = {{1, 2, 0}, {3, 2, 0}, {3, 6, 0}};
  set.edges = {{0, 1}, {1, 2}};
  const std::string svg = format_lines_svg(set);
  EXPECT_NE(svg.find("d=\"M1 6L3 6L3 2\""), std::string::npos) << svg;
}

TEST(Lines, SvgOfAnotherPlaneKeepsLengths) {
  const std::string svg = format_lines_svg(lines());
  const std::size_t at = svg.find("d=\"M");
  double x0, y0, x1, y1;
  ASSERT_EQ(std::sscanf(svg.c_str() + at, "d=\"M%lf %lfL%lf %lf", &x0, &y0, &x1, &y1), 4);
  const LineSet set = lines();
  EXPECT_NEAR(std::hypot(x1 - x0, y1 - y0), (set.points[1] - set.points[0]).norm(), 1e-12);
}

/// A bent line over a seam: its two edges on each side join, and the sides lie apart.
LineSet over_a_seam() {
  LineSet set;
  set.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 5}, {3, 1, 5}, {4, 0, 5}};
  set.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  set.uvs = {{0, 0}, {0.25, 0}, {0.25, 1e-12}, {0.5, 0}, {0.5, 0.75}, {0.75, 1}, {0.75, 1}, {1, 1}};
  set.edge_attributes = {{"uv_island", 1, {0, 0, 1, 1}}};
  return set;
}

TEST(Lines, SvgIsDrawnInUvSpaceWhereThereIsOne) {
  LineSet set = over_a_seam();
  const std::string svg = format_lines_svg(set);
  EXPECT_NE(svg.find("<path id=\"island_0\" d=\"M0 1L0.25 1L0.5 1\"/>"), std::string::npos) << svg;
  EXPECT_NE(svg.find("<path id=\"island_1\" d=\"M0.5 0.25L0.75 0L1 0\"/>"), std::string::npos);
  set.uvs.clear();  // nor is it flat
  message_of([&] { format_lines_svg(set); }, ErrorKind::request);
}

TEST(Lines, SvgHasASizeOfItsOwnWithTheShapeOfItsView) {
  for (const LineSet& set : {over_a_seam(), lines(), LineSet{}}) {
    const std::string svg = format_lines_svg(set);
    double width, height, x, y, w, h;
    ASSERT_EQ(std::sscanf(svg.c_str() + svg.find(" width="),
                          " width=\"%lf\" height=\"%lf\" viewBox=\"%lf %lf %lf %lf\"", &width,
                          &height, &x, &y, &w, &h),
              6)
        << svg;
    EXPECT_NEAR(std::max(width, height), 1024, 1e-9);
    EXPECT_NEAR(width / height, w / h, 1e-9);
  }
}

TEST(Lines, SvgLeavesOutWhatHasNoUvsAndSaysSo) {
  LineSet set = over_a_seam();
  set.edge_attributes[0].values = {0, 0, -1, -1};
  std::vector<std::string> said;
  const auto warn = [&](const std::string& warning) { said.push_back(warning); };
  const std::string svg = format_lines_svg(set, warn);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(said[0].starts_with("2 of 4 pieces of crack are not in the SVG")) << said[0];
  EXPECT_EQ(svg.find("island_1"), std::string::npos);
  EXPECT_NE(svg.find("island_0"), std::string::npos);
}

TEST(Lines, SvgOfPartsWithoutUvsIsDrawnOnTheirPlane) {
  LineSet set = lines();
  set.uvs.assign(2 * set.edges.size(), Vec2(0, 0));
  EXPECT_EQ(format_lines_svg(set), format_lines_svg(lines()));
  set.points[0].z() = 100;
  message_of([&] { format_lines_svg(set); }, ErrorKind::request);
}

TEST(Lines, GoToFilesByExtension) {
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.obj", "a.SVG", "a.json"})
    write_lines(folder / name, lines());
  EXPECT_TRUE(read_file(folder / "a.SVG").starts_with("<svg"));
  message_of([&] { write_lines(folder / "a.stl", lines()); }, ErrorKind::usage);
}

}  // namespace
}  // namespace craze
