#include "craze/io/stl/stl.h"

#include "craze/io/bytes/byte_order.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

SurfaceMesh square() {
  SurfaceMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0.5}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(Stl, EqualCornersBecomeOneVertexInTheOrderOfTheFile) {
  const SurfaceMesh mesh = square(), back = read_stl(format_stl(mesh), "a.stl");
  EXPECT_EQ(back.positions, mesh.positions);
  EXPECT_EQ(back.triangles, mesh.triangles);
}

TEST(Stl, NegativeZeroIsTheSamePlaceAsZero) {
  SurfaceMesh mesh = square();
  mesh.positions.emplace_back(-0.0, -0.0, -0.0);
  mesh.triangles[1][0] = 4;
  EXPECT_EQ(read_stl(format_stl(mesh), "a.stl").positions.size(), 4u);
}

TEST(Stl, ABinaryFileMayStartWithSolid) {
  std::string bytes = format_stl(square());
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(read_stl(bytes, "a.stl").triangles.size(), 2u);
}

TEST(Stl, BinaryFilesMayHaveBytesAfterTheLastTriangle) {
  EXPECT_EQ(read_stl(format_stl(square()) + "trailer", "a.stl").triangles.size(), 2u);
}

TEST(Stl, AsciiFilesMayHoldSeveralSolidsInAnyCase) {
  const std::string facet =
      "FACET NORMAL 0 0 1\n OUTER LOOP\n  VERTEX 0 0 0\n  vertex 1e0 0 0\n  vertex 0 .5 0\n"
      " ENDLOOP\nENDFACET\n";
  const auto mesh = read_stl(
      "solid part vertex 1\n" + facet + "endsolid\n\nSOLID\n" + facet + "ENDSOLID\n", "a.stl");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}}));
  EXPECT_EQ(mesh.positions[2], Vec3(0, 0.5, 0));
}

TEST(Stl, NormalsAreThoseOfTheTrianglesAndZeroWithoutArea) {
  SurfaceMesh mesh = square();
  mesh.triangles.push_back({0, 0, 1});
  const std::string bytes = format_stl(mesh);
  EXPECT_NEAR(load<float>(bytes.data() + 84 + 8), 1 / std::sqrt(1.25), 1e-7);
  EXPECT_EQ(load<float>(bytes.data() + 84 + 100 + 8), 0.0f);
}

TEST(Stl, CoordinatesBeyondFloatAreRefused) {
  SurfaceMesh mesh = square();
  mesh.positions[0].x() = 1e39;
  message_of([&] { format_stl(mesh); }, ErrorKind::request);
}

}  // namespace
}  // namespace craze
