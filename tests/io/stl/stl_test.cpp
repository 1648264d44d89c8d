#include "craze/io/stl/stl.h"

#include <cstring>
#include <limits>

#include "craze/io/bytes/byte_order.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

SurfaceMesh read(const std::string& bytes, const std::string& name = "a.stl") {
  return read_mesh(bytes, name).mesh;
}

SurfaceMesh square() {
  SurfaceMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0.5}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(Stl, EqualCornersBecomeOneVertexInTheOrderOfTheFile) {
  const SurfaceMesh mesh = square(), back = read(format_mesh(mesh, "stl"), "a.stl");
  EXPECT_EQ(back.positions, mesh.positions);
  EXPECT_EQ(back.triangles, mesh.triangles);
}

TEST(Stl, NegativeZeroIsTheSamePlaceAsZero) {
  SurfaceMesh mesh = square();
  mesh.positions.emplace_back(-0.0, -0.0, -0.0);
  mesh.triangles[1][0] = 4;
  EXPECT_EQ(read(format_mesh(mesh, "stl"), "a.stl").positions.size(), 4u);
}

TEST(Stl, ABinaryFileMayStartWithSolid) {
  std::string bytes = format_mesh(square(), "stl");
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(read(bytes, "a.stl").triangles.size(), 2u);
}

TEST(Stl, BinaryFilesMayHaveBytesAfterTheLastTriangle) {
  EXPECT_EQ(read(format_mesh(square(), "stl") + "trailer", "a.stl").triangles.size(), 2u);
}

TEST(Stl, AsciiFilesMayHoldSeveralSolidsInAnyCase) {
  const std::string facet =
      "FACET NORMAL 0 0 1\n OUTER LOOP\n  VERTEX 0 0 0\n  vertex 1e0 0 0\n  vertex 0 .5 0\n"
      " ENDLOOP\nENDFACET\n";
  const auto mesh =
      read("solid part vertex 1\n" + facet + "endsolid\n\nSOLID\n" + facet + "ENDSOLID\n", "a.stl");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}}));
  EXPECT_EQ(mesh.positions[2], Vec3(0, 0.5, 0));
}

TEST(Stl, ColorsOfFacesComeBackAsTheyWereRead) {
  std::string bytes = format_mesh(square(), "stl");
  for (const std::size_t f : {0, 1}) {
    const auto color =
        static_cast<std::uint16_t>(f == 0 ? 0x8000 | 3 << 10 | 30 << 5 | 17 : 0xffff);
    std::memcpy(bytes.data() + 84 + 50 * f + 48, &color, 2);
  }
  const SurfaceMesh mesh = read(bytes);
  ASSERT_EQ(mesh.face_attributes.size(), 3u);
  EXPECT_EQ(format_mesh(mesh, "stl"), bytes);
}

TEST(Stl, ColorsThatAreNoNumbersOrOutOfRangeAreClamped) {
  SurfaceMesh mesh = square();
  const double none = std::numeric_limits<double>::quiet_NaN();
  mesh.face_attributes = {{"red", 1, {none, -5}}, {"green", 1, {300, 0}}, {"blue", 1, {0, 255}}};
  const std::string bytes = format_mesh(mesh, "stl");
  EXPECT_EQ(load<std::uint16_t>(bytes.data() + 84 + 48), 0x8000 | 31 << 5);
  EXPECT_EQ(load<std::uint16_t>(bytes.data() + 84 + 98), 0x8000 | 31);
}

TEST(Stl, NormalsAreThoseOfTheTrianglesAndZeroWithoutArea) {
  SurfaceMesh mesh = square();
  mesh.triangles.push_back({0, 0, 1});
  const std::string bytes = format_mesh(mesh, "stl");
  EXPECT_NEAR(load<float>(bytes.data() + 84 + 8), 1 / std::sqrt(1.25), 1e-7);
  EXPECT_EQ(load<float>(bytes.data() + 84 + 100 + 8), 0.0f);
}

TEST(Stl, CoordinatesBeyondFloatAreRefused) {
  SurfaceMesh mesh = square();
  mesh.positions[0].x() = 1e39;
  message_of([&] { format_mesh(mesh, "stl"); }, ErrorKind::request);
}

/// A binary file of the square whose last two bytes of each record are these.
std::string with_attributes(std::uint16_t first, std::uint16_t second) {
  std::string bytes = format_mesh(square(), "stl");
  store(bytes.data() + 84 + 48, first);
  store(bytes.data() + 84 + 98, second);
  return bytes;
}

std::vector<double> channel(const SurfaceMesh& mesh, const char* name) {
  const Attribute* a = find_attribute(mesh.face_attributes, name);
  return a ? a->values : std::vector<double>{};
}

TEST(Stl, ABinaryFileThatSaysSolidMayHaveMoreBytesThanItsTriangles) {
  std::string bytes = format_mesh(square(), "stl") + "exported by hand";
  bytes.replace(0, 10, "solid part");
  const MeshFile file = read_mesh(bytes, "a.stl");
  EXPECT_EQ(file.mesh.triangles.size(), 2u);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_NE(file.warnings[0].find("16 bytes after the last"), std::string::npos);
}

TEST(Stl, RecordsAreAsLongAsTheirAttributeByteCountsSay) {
  std::string bytes = with_attributes(5, 3);
  bytes.insert(84 + 50, "12345");
  EXPECT_EQ(read(bytes + "123").triangles, square().triangles);
  EXPECT_TRUE(read(bytes + "123").face_attributes.empty());
}

TEST(Stl, AttributeBytesAreColoursWithTheFlag) {
  // Red in the highest five bits.
  const SurfaceMesh mesh = read(with_attributes(0x8000 | 31 << 10, 0));
  EXPECT_EQ(channel(mesh, "red"), (std::vector<double>{255, 255}));
  EXPECT_EQ(channel(mesh, "green"), (std::vector<double>{0, 255})) << "white without the flag";
  EXPECT_TRUE(read(with_attributes(31, 31)).face_attributes.empty()) << "no flag at all";
}

TEST(Stl, MagicsPutsRedLowestAndKnowsAColourForTheWhole) {
  std::string bytes = with_attributes(31, 0x8000);
  const std::string_view color = "COLOR=\x0a\x14\x1e\xff";
  bytes.replace(30, color.size(), color);
  const SurfaceMesh mesh = read(bytes);
  EXPECT_EQ(channel(mesh, "red"), (std::vector<double>{255, 10}));
  EXPECT_EQ(channel(mesh, "green"), (std::vector<double>{0, 20}));
  EXPECT_EQ(channel(mesh, "blue"), (std::vector<double>{0, 30}));
}

TEST(Stl, ColoursOfFacesAreWrittenToPlyAsOtherProgramsReadThem) {
  const std::string ply = format_mesh(read(with_attributes(0x8000 | 31 << 5, 0x8000)), "ply");
  EXPECT_NE(ply.find("property uchar red"), std::string::npos);
  EXPECT_EQ(channel(read_mesh(ply, "a.ply").mesh, "green"), (std::vector<double>{255, 0}));
}

TEST(Stl, AsciiIsWordsAndNotLines) {
  const auto mesh = read(
      "  solid a facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0\n0 vertex 0\n\t1 0 endloop "
      "endfacet\n\nfacet\nnormal nan nan\nnan\nouter loop\nvertex 0 0 0\nvertex 0 1 0\n"
      "vertex -1 0 0\nendloop\nendfacet endsolid a\nsolid b\nendsolid b");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

}  // namespace
}  // namespace craze
