#include "craze/io/obj/obj.h"
#include "craze/read_mesh.h"

#include "io/io_test_tools.h"

namespace craze {
namespace {

constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

SurfaceMesh read_surface(const std::string& text) {
  return read_mesh(text, "a.obj").mesh;
}

TEST(Obj, NegativeIndicesCountBackFromTheLastVertexSoFar) {
  const auto mesh = read_surface(std::string(square) + "f -4 -3 -2\nv 5 5 5\nf -5 -3 -2\n");
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(mesh.triangles[1], (Triangle{0, 2, 3}));
}

TEST(Obj, PolygonsBecomeTrianglesThatRememberThem) {
  const auto mesh = read_surface(std::string(square) + "f 1 2 3\nf 1 2 3 4\n");
  EXPECT_EQ(mesh.source_faces, (std::vector<std::int32_t>{0, 1, 1}));
}

TEST(Obj, LinesContinueAfterABackslash) {
  const auto mesh = read_surface(std::string(square) + "f 1 \\\n 2 \\\r\n 3\n");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(Obj, SeamsKeepTheirOwnUvs) {
  const auto mesh = read_surface(std::string(square) +
                                 "vt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.5\n"
                                 "f 1/1 2/2 3/3\nf 1/4 3/3 4\n");
  EXPECT_EQ(mesh.corner_uvs[0], Vec2(0, 0));
  EXPECT_EQ(mesh.corner_uvs[3], Vec2(0.5, 0.5));
  EXPECT_EQ(mesh.corner_uvs[5], Vec2(0, 0)) << "a corner without vt";
}

TEST(Obj, NormalsAreMadeUnitAndMissingOnesAreTheFaces) {
  const auto mesh = read_surface(std::string(square) + "vn 0 3 4\nvn 0 0 0\nf 1//1 2//2 3\n");
  EXPECT_NEAR((mesh.corner_normals[0] - Vec3(0, 0.6, 0.8)).norm(), 0, 1e-15);
  EXPECT_EQ(mesh.corner_normals[1], Vec3(0, 0, 1));
  EXPECT_EQ(mesh.corner_normals[2], Vec3(0, 0, 1));
}

TEST(Obj, NormalsStayUnitWhereEdgesOverflow) {
  const auto mesh = read_surface("v 0 1e308 0\nv 0 -1e308 0\nv 1e308 0 0\nvn 0 0 1\nf 1//1 2 3\n");
  for (const Vec3& n : mesh.corner_normals) EXPECT_NEAR(n.norm(), 1, 1e-12);
}

TEST(Obj, ColoursFollowTheCoordinates) {
  const auto mesh = read_surface("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 0 0 1 0.25\nf 1 2 3\n");
  EXPECT_EQ(mesh.vertex_colors[0], (Color{1, 0.5f, 0, 1}));
  EXPECT_EQ(mesh.vertex_colors[1], (Color{1, 1, 1, 1}));
  EXPECT_EQ(mesh.vertex_colors[2], (Color{0, 0, 1, 0.25f}));
}

TEST(Obj, ColoursAreWrittenWithinTheirBounds) {
  SurfaceMesh mesh = read_surface("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  mesh.vertex_colors.assign(3, Color{std::nextafter(1.0f, 2.0f), 0, 0, 1});
  EXPECT_TRUE(read_mesh(format_mesh(mesh, "obj"), "a.obj").warnings.empty());
}

TEST(Obj, MaterialsGoByNameAndNoFileIsAskedFor) {
  const auto mesh =
      read_surface(std::string("mtllib gone.mtl\n") + square +
                   "f 1 2 3\nusemtl raw clay\nf 1 3 4\nusemtl b\nf 1 2 4\nusemtl raw clay\n"
                   "f 2 3 4\nusemtl (null)\nf 1 2 3\n");
  EXPECT_EQ(mesh.material_names, (std::vector<std::string>{"raw clay", "b"}));
  EXPECT_EQ(mesh.face_materials, (std::vector<std::int32_t>{-1, 0, 1, 0, -1}));
}

TEST(Obj, WhatIsNoSurfaceIsSkipped) {
  const auto mesh = read_surface(std::string("# by hand\r\no thing\r\ng a b\r\ns off\r\n") +
                                 square + "l 1 2 3\np 1\nf 1 2\nvp 1 2\nf 1 2 3 # the only one\n");
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(Obj, NumbersAreReadToTheLastBit) {
  const auto mesh =
      read_surface("v 0.1 1e-310 +3.141592653589793\nv 1e308 -1e-400 2\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions[0], Vec3(0.1, 1e-310, 3.141592653589793));
  EXPECT_EQ(mesh.positions[1], Vec3(1e308, 0, 2)) << "a number too small for a double is zero";
}

TEST(Obj, WhatIsWrittenReadsBackTheSame) {
  const SurfaceMesh mesh = rich_mesh(), back = read_surface(format_mesh(mesh, "obj"));
  EXPECT_EQ(back.positions, mesh.positions);
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(back.corner_uvs, mesh.corner_uvs);
  expect_same_corners(mesh, back, 0);
  expect_same_materials(mesh, back);
  EXPECT_EQ(back.vertex_colors, mesh.vertex_colors);
}

TEST(Obj, FacesWithoutMaterialStayWithout) {
  SurfaceMesh mesh = rich_mesh();
  mesh.face_materials[3] = -1;
  const SurfaceMesh back = read_surface(format_mesh(mesh, "obj"));
  EXPECT_EQ(back.face_materials[3], -1);
  EXPECT_EQ(back.material_names[back.face_materials[4]], mesh.material_names[0]);
}

TEST(Obj, ABackslashEndsTheTokenBeforeIt) {
  const auto mesh =
      read_surface("v 0 0 \\\n0\nv 1 0 0\\\n\nv 1 1 0\nf 1\\\r\n 2 3\\\n\n# f 1 \\\nf 1 3 2\n");
  EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 1}}));
}

TEST(Obj, LinesEndInAnyOfThreeWays) {
  const std::string text = std::string(square) + "f 1\t2 3\nf 1 3 4\n";
  for (const std::string end : {"\r", "\r\n"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(read_surface(other).triangles, read_surface(text).triangles);
    EXPECT_EQ(read_surface(other).positions, read_surface(text).positions);
  }
}

TEST(Obj, SlotsOfCornersMayBeEmpty) {
  const std::string uvs = std::string(square) + "vt 0 0\nvn 0 0 1\n";
  for (const char* face : {"f 1// 2// 3//", "f 1/ 2/ 3/", "f 1/1/ 2/1/ 3/1/", "f 1//1 2//1 3//1"}) {
    EXPECT_EQ(read_surface(uvs + face).triangles, (std::vector<Triangle>{{0, 1, 2}})) << face;
  }
  EXPECT_TRUE(read_surface(uvs + "f 1// 2// 3//").corner_normals.empty());
  EXPECT_EQ(read_surface(uvs + "f 1/1/ 2/1/ 3/1/").corner_uvs.size(), 3u);
}

TEST(Obj, UvsAndNormalsThatAreNeverGivenAreLeftOutWithAWarning) {
  for (const char* face : {"f 1/1 2/2 3/3", "f 1//1 2//2 3//3", "f -4/-1 -3/-1 -2/-1"}) {
    const MeshFile file = read_mesh(std::string(square) + face, "a.obj");
    EXPECT_EQ(file.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}})) << face;
    EXPECT_TRUE(file.mesh.corner_uvs.empty() && file.mesh.corner_normals.empty());
    ASSERT_EQ(file.warnings.size(), 1u) << face;
    EXPECT_NE(file.warnings[0].find("3 corners name"), std::string::npos) << file.warnings[0];
  }
  const MeshFile some = read_mesh(std::string(square) + "vt 0.5 1\nf 1/1 2/2 3/1", "a.obj");
  EXPECT_EQ(some.mesh.corner_uvs, (std::vector<Vec2>{{0.5, 1}, {0, 0}, {0.5, 1}}));
}

TEST(Obj, NumbersMayLackDigitsOnOneSideOfThePoint) {
  const auto mesh = read_surface("v .06 1. +1\nv -.5 1e5 1E-2\nv +.5 0 -0\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions[0], Vec3(0.06, 1, 1));
  EXPECT_EQ(mesh.positions[1], Vec3(-0.5, 1e5, 1e-2));
  EXPECT_EQ(mesh.positions[2], Vec3(0.5, 0, 0));
  message_of([] { read_surface("v +-1 0 0\n"); });
}

TEST(Obj, LinesOfOtherKindsAreNamed) {
  const MeshFile file =
      read_mesh("g a\ng b\n" + std::string(square) + "l 1 2\nf 1 2 3\ns off\n", "a.obj");
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_EQ(file.warnings[0], "lines of these kinds are not kept: 1 'l'");
}

TEST(Obj, FacesBelongToTheObjectAndGroupNamedBeforeThem) {
  const auto mesh = read_surface(std::string(square) +
                                 "f 1 2 3\no cup\nf 1 2 3\ng rim\nf 1 2 3\ng foot\nf 1 2 3\n"
                                 "o  my saucer \nf 1 2 3\no cup\ng rim\nf 1 2 3\ng\nf 1 2 3\n");
  EXPECT_EQ(mesh.object_names,
            (std::vector<std::string>{"cup", "cup/rim", "cup/foot", "my saucer"}));
  EXPECT_EQ(mesh.face_objects, (std::vector<std::int32_t>{-1, 0, 1, 2, 3, 1, 0}));
  EXPECT_EQ(read_surface("g a b\n" + std::string(square) + "f 1 2 3\n").object_names,
            (std::vector<std::string>{"a b"}));
  EXPECT_TRUE(read_surface(std::string(square) + "f 1 2 3\n").face_objects.empty());
}

}  // namespace
}  // namespace craze
