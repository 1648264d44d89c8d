#include "craze/io/off/off.h"
#include "craze/read_mesh.h"

#include "io/io_test_tools.h"

namespace craze {
namespace {

SurfaceMesh read(const std::string& text) {
  return read_mesh(text, "a.off").mesh;
}

TEST(Off, CommentsAndBlankLinesAreSkipped) {
  const auto mesh = read(
      "OFF # a square\n\n# counts\n4 2 0\n0 0 0\n1 0 0\n# between\n1 1 0\n0 1 0\n"
      "3 0 1 2 255 0 0\n4 0 1 2 3\n");
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.source_faces, (std::vector<std::int32_t>{0, 1, 1}));
}

TEST(Off, CountsMayFollowTheKeyword) {
  EXPECT_EQ(read("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").triangles.size(), 1u);
}

TEST(Off, TheKeywordMayBeMissing) {
  EXPECT_EQ(read("# a\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").triangles.size(), 1u);
  EXPECT_NE(message_of([] { read("0.5 0 0\n"); }).find("OFF"), std::string::npos);
}

TEST(Off, ColoursAreOfEitherScale) {
  const auto color = [](const std::string& rgba) {
    return read("COFF\n3 1 0\n0 0 0 " + rgba + "\n1 0 0 " + rgba + "\n0 1 0 " + rgba +
                "\n3 0 1 2\n")
        .vertex_colors[0];
  };
  EXPECT_EQ(color("255 51 0"), (Color{1, 0.2f, 0, 1}));
  EXPECT_EQ(color("255 51 0 255"), (Color{1, 0.2f, 0, 1}));
  EXPECT_EQ(color("1 0.2 0 0.5"), (Color{1, 0.2f, 0, 0.5f}));
}

TEST(Off, NormalsAndUvsGoToTheCorners) {
  const auto mesh = read(
      "STCNOFF\n3 1 0\n0 0 0 0 0 2 1 1 1 0.5 0\n1 0 0 0 0 2 1 1 1 1 0\n"
      "0 1 0 0 0 2 1 1 1 0 1\n3 0 1 2\n");
  EXPECT_EQ(mesh.corner_normals[1], Vec3(0, 0, 1));
  EXPECT_EQ(mesh.corner_uvs[0], Vec2(0.5, 0));
}

TEST(Off, OtherDimensionsAndBinaryAreRefusedByName) {
  EXPECT_NE(message_of([] { read("4OFF\n1 1 0\n"); }).find("4OFF"), std::string::npos);
  EXPECT_NE(message_of([] { read("OFF BINARY\n"); }).find("binary"), std::string::npos);
}

TEST(Off, TokensMayStandOnAnyLine) {
  const std::vector<Triangle> expected{{0, 1, 2}, {0, 2, 3}};
  for (const char* text : {"OFF 4 1 0 0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3",
                           "OFF\n4\n1\n0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1\n2 3\n",
                           // As many lines as rows, but not a row a line.
                           "OFF\n4 1 0\n0 0 0 1 0 0\n1 1\n0\n0 1 0\n4 0 1 2 3\n",
                           "OFF\n4 1 0\n0 0 0 1 0\n0 1 1 0\n0 1 0\n4 0 1\n2 3\n"}) {
    EXPECT_EQ(read(text).triangles, expected) << text;
  }
}

TEST(Off, ColoursOfFacesAreKept) {
  const auto red = [](const std::string& text) {
    const SurfaceMesh mesh = read(text);
    const Attribute* a = find_attribute(mesh.face_attributes, "red");
    return a ? a->values : std::vector<double>{};
  };
  const std::string vertices = "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(red(vertices + "3 0 1 2 204 0 0\n3 2 1 0\n"), (std::vector<double>{204, 255}));
  EXPECT_EQ(red(vertices + "3 0 1 2 0.2 0 0 1\n3 2 1 0 1 1 1\n"), (std::vector<double>{51, 255}));
  EXPECT_TRUE(red(vertices + "3 0 1 2\n3 2 1 0\n").empty());
}

TEST(Off, MoreNumbersThanTheFirstWordSaysAreSkippedWithAWarning) {
  const MeshFile file =
      read_mesh("OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2\n", "a.off");
  EXPECT_EQ(file.mesh.positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(file.warnings.size(), 1u);
}

}  // namespace
}  // namespace craze
