#include "craze/io/ply/ply.h"
#include "craze/read_mesh.h"

#include "craze/io/bytes/byte_order.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

SurfaceMesh read_surface(const std::string& bytes) {
  return read_mesh(bytes, "a.ply").mesh;
}

template <class T>
void append_big(std::string& bytes, T value) {
  char buffer[sizeof(T)];
  store(buffer, value);
  bytes.append(std::string(buffer, sizeof(T)).assign(std::rbegin(buffer), std::rend(buffer)));
}

TEST(Ply, PropertiesMayComeInAnyOrderAndType) {
  const auto mesh = read_surface(
      "ply\nformat ascii 1.0\ncomment z first\nelement vertex 3\nproperty double z\n"
      "property short confidence\nproperty int x\nproperty uchar y\nelement face 1\n"
      "property float q\nproperty list int short vertex_index\nend_header\n"
      "0.5 7 0 0\n0.5 8 1 0\n0.5 9 0 1\n2.5 3 0 1 2\n");
  EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0.5));
  EXPECT_EQ(find_attribute(mesh.vertex_attributes, "confidence")->values,
            (std::vector<double>{7, 8, 9}));
  EXPECT_EQ(find_attribute(mesh.face_attributes, "q")->values, (std::vector<double>{2.5}));
}

TEST(Ply, BothByteOrdersAreRead) {
  const std::string header =
      "_endian 1.0\nelement vertex 3\nproperty float x\nproperty double y\nproperty short z\n"
      "element face 1\nproperty list ushort uint vertex_indices\nend_header\n";
  std::string little = "ply\nformat binary_little" + header;
  std::string big = "ply\nformat binary_big" + header;
  const double places[3][3] = {{0, 0, -3}, {1.5, 0, 0}, {0, 0.1, 300}};
  for (const auto& p : places) {
    append(little, static_cast<float>(p[0]));
    append(little, p[1]);
    append(little, static_cast<std::int16_t>(p[2]));
    append_big(big, static_cast<float>(p[0]));
    append_big(big, p[1]);
    append_big(big, static_cast<std::int16_t>(p[2]));
  }
  append(little, std::uint16_t{3});
  append_big(big, std::uint16_t{3});
  for (std::uint32_t v = 0; v < 3; ++v) {
    append(little, v);
    append_big(big, v);
  }
  EXPECT_EQ(read_surface(little).positions, read_surface(big).positions);
  EXPECT_EQ(read_surface(big).positions[2], Vec3(0, 0.1, 300));
  EXPECT_EQ(read_surface(big).triangles[0], (Triangle{0, 1, 2}));
}

TEST(Ply, UnknownElementsAndListsAreSkipped) {
  const auto mesh = read_surface(
      "ply\nformat ascii 1.0\nelement camera 2\nproperty float fov\nproperty list uchar int ids\n"
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property list uchar float weights\nelement face 1\n"
      "property list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\nend_header\n"
      "1 2 5 6\n1 0\n0 0 0 1 9\n1 0 0 0\n0 1 0 2 9 9\n3 0 1 2\n0\n");
  EXPECT_EQ(mesh.positions[2], Vec3(0, 1, 0));
  EXPECT_TRUE(mesh.vertex_attributes.empty());
}

TEST(Ply, PolygonsShareTheirFacesValues) {
  const auto mesh = read_surface(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
      "property float q\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 5\n3 0 1 2 6\n");
  EXPECT_EQ(mesh.source_faces, (std::vector<std::int32_t>{0, 0, 1}));
  EXPECT_EQ(find_attribute(mesh.face_attributes, "q")->values, (std::vector<double>{5, 5, 6}));
}

TEST(Ply, ColoursOfBytesAndOfFloatsAreFromZeroToOne) {
  const std::string body = "property float x\nproperty float y\nproperty float z\n";
  const auto read_color = [&](const std::string& type, const std::string& rgb) {
    return read_surface(
               "ply\nformat ascii 1.0\nelement vertex 3\n" + body + "property " + type +
               " red\nproperty " + type + " green\nproperty " + type +
               " blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 " +
               rgb + "\n1 0 0 " + rgb + "\n0 1 0 " + rgb + "\n3 0 1 2\n")
        .vertex_colors[0];
  };
  EXPECT_EQ(read_color("uchar", "255 51 0"), (Color{1, 0.2f, 0, 1}));
  EXPECT_EQ(read_color("float", "1 0.2 0"), (Color{1, 0.2f, 0, 1}));
}

TEST(Ply, UvsOfVerticesAndOfFaces) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\n";
  const auto by_vertex =
      read_surface(head +
                   "property float texture_u\nproperty float texture_v\nelement face 1\n"
                   "property list uchar int vertex_indices\nend_header\n"
                   "0 0 0 0 0.5\n1 0 0 1 0.5\n0 1 0 0 1\n3 0 1 2\n");
  EXPECT_EQ(by_vertex.corner_uvs[1], Vec2(1, 0.5));
  const auto by_face = read_surface(head +
                                    "element face 1\nproperty list uchar int vertex_indices\n"
                                    "property list uchar float texcoord\nend_header\n"
                                    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0.5 1 0.5 0 1\n");
  EXPECT_EQ(by_face.corner_uvs, by_vertex.corner_uvs);
}

TEST(Ply, WhatIsWrittenReadsBackTheSame) {
  const SurfaceMesh mesh = rich_mesh(), back = read_surface(format_mesh(mesh, "ply"));
  expect_same_corners(mesh, back, 0);
  expect_same_materials(mesh, back);
  expect_same_at_corners(mesh, back, "crack_time", 0);
  expect_same_at_corners(mesh, back, "displacement", 0);
  ASSERT_EQ(back.face_attributes.size(), 1u);
  EXPECT_EQ(back.face_attributes[0].values, mesh.face_attributes[0].values);
}

TEST(Ply, WithoutSeamsVerticesStayAsTheyAre) {
  SurfaceMesh mesh = rich_mesh();
  mesh.corner_uvs.clear();
  mesh.corner_normals.clear();
  const SurfaceMesh back = read_surface(format_mesh(mesh, "ply"));
  EXPECT_EQ(back.positions, mesh.positions);
  EXPECT_EQ(back.triangles, mesh.triangles);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(back.vertex_colors[v][k], mesh.vertex_colors[v][k], 0.5 / 255 + 1e-6);
    }
  }
}

TEST(Ply, NamesOfAttributesBecomeWordsOfTheirOwn) {
  SurfaceMesh mesh = rich_mesh();
  mesh.corner_uvs.clear();
  mesh.corner_normals.clear();
  const std::vector<double> values(mesh.positions.size(), 1.5);
  mesh.vertex_attributes = {{"x", 1, values}, {"grain size\n", 1, values}, {"", 1, values}};
  const SurfaceMesh back = read_surface(format_mesh(mesh, "ply"));
  EXPECT_EQ(back.positions, mesh.positions);
  for (const char* name : {"x_", "grain_size_", "unnamed"}) {
    EXPECT_NE(find_attribute(back.vertex_attributes, name), nullptr) << name;
  }
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string indices = "property list uchar int vertex_indices\n";

std::string quad(const std::string& properties, const std::string& values) {
  return "ply\nformat ascii 1.0\nelement vertex 4\n" + xyz + properties + "element face 1\n" +
         indices + "end_header\n0 0 0 " + values + "\n1 0 0 " + values + "\n1 1 0 " + values +
         "\n0 1 0 " + values + "\n4 0 1 2 3\n";
}

TEST(Ply, StripsEndWithMinusOneAndTurnEveryOtherTriangle) {
  for (const char* type : {"int", "uint"}) {
    const bool is_signed = std::string(type) == "int";
    const auto mesh =
        read_surface(std::string("ply\nformat ascii 1.0\nelement vertex 4\n") + xyz +
                     "element tristrips 1\nproperty list int " + type +
                     " vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n9 0 1 2 3 " +
                     (is_signed ? "-1" : "4294967295") + " 0 1 2 2\n");
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {0, 1, 2}})) << type;
  }
}

TEST(Ply, RowsLongerThanTheHeaderLoseTheirRest) {
  const MeshFile file = read_mesh(quad("", "0.5 0.5"), "a.ply");
  EXPECT_EQ(file.mesh.positions[2], Vec3(1, 1, 0));
  EXPECT_EQ(file.mesh.triangles.size(), 2u);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_NE(file.warnings[0].find("4 rows hold more"), std::string::npos);
}

TEST(Ply, RowsMayShareALine) {
  std::string text = quad("", "");
  const std::size_t body = text.find("end_header\n") + 11;
  std::replace(text.begin() + static_cast<std::ptrdiff_t>(body), text.end(), '\n', ' ');
  EXPECT_EQ(read_surface(text).positions, read_surface(quad("", "")).positions);
}

TEST(Ply, ColoursAndUvsGoByManyNames) {
  for (const char* prefix : {"", "diffuse_"}) {
    const std::string p = std::string("property uchar ") + prefix;
    const auto mesh = read_surface(quad(p + "red\n" + p + "green\n" + p + "blue\n", "255 51 0"));
    ASSERT_EQ(mesh.vertex_colors.size(), 4u) << prefix;
    EXPECT_EQ(mesh.vertex_colors[0], (Color{1, 0.2f, 0, 1}));
  }
  for (const char* names : {"s t", "u v", "texture_u texture_v", "texture_s texture_t"}) {
    const std::string both = names;
    const std::size_t space = both.find(' ');
    const auto mesh = read_surface(quad("property float " + both.substr(0, space) +
                                            "\nproperty float " + both.substr(space + 1) + "\n",
                                        "0.25 0.75"));
    ASSERT_EQ(mesh.corner_uvs.size(), 6u) << names;
    EXPECT_EQ(mesh.corner_uvs[0], Vec2(0.25, 0.75));
  }
}

TEST(Ply, FloatColoursAreOfEitherScale) {
  const std::string rgb = "property float red\nproperty float green\nproperty float blue\n";
  EXPECT_EQ(read_surface(quad(rgb, "255 51 0")).vertex_colors[0], (Color{1, 0.2f, 0, 1}));
  EXPECT_EQ(read_surface(quad(rgb, "1 0.5 0")).vertex_colors[0], (Color{1, 0.5f, 0, 1}));
  EXPECT_EQ(read_surface(quad(rgb + "property float alpha\n", "255 51 0 0.5")).vertex_colors[0],
            (Color{1, 0.2f, 0, 0.5f}));
}

TEST(Ply, HeadersOfAnyLineEndLeaveBinaryRowsWhole) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
      "property uchar x\nproperty uchar y\nproperty uchar z\nelement face 1\n"
      "property list uchar uchar vertex_indices\nend_header\n";
  const std::string body("\n\r\n\0\r\0\0\0\1\3\0\1\2", 13);
  for (const std::string end : {"\n", "\r", "\r\n"}) {
    std::string other;
    for (const char c : header) other += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(read_surface(other + body).positions[0], Vec3(10, 13, 10));
  }
}

TEST(Ply, IntegersOf64BitsAreRead) {
  const auto mesh =
      read_surface("ply\nformat ascii 1.0\nobj_info by hand\nelement vertex 3\n" + xyz +
                   "property uint64 id\nelement face 1\nproperty list uint64 int64 "
                   "vertex_index\nend_header\n0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1 2\n");
  EXPECT_EQ(find_attribute(mesh.vertex_attributes, "id")->values, (std::vector<double>{7, 8, 9}));
}

TEST(Ply, TexturesAreTold) {
  std::string text = quad("", "");
  text.insert(text.find("element vertex"), "comment TextureFile my clay.png\n");
  EXPECT_EQ(read_mesh(text, "a.ply").textures, (std::vector<std::string>{"my clay.png"}));
}

}  // namespace
}  // namespace craze
