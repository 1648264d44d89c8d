// Textures, colours and header lines of PLY files.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "craze/io/bytes/byte_order.h"
#include "craze/read_mesh.h"
#include "craze/write_mesh.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

namespace fs = std::filesystem;

const std::string png = "\x89PNG\r\n\x1a\n and so on";

/// A square of two triangles with UVs; `header` lines, `properties` of vertices and faces with a
/// value each.
std::string square(const std::string& header, const std::string& properties = "",
                   const std::string& values = "", const std::string& of_faces = "",
                   const std::string& first = "", const std::string& second = "") {
  return "ply\nformat ascii 1.0\n" + header +
         "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "property float s\nproperty float t\n" +
         properties + "element face 2\nproperty list uchar int vertex_indices\n" + of_faces +
         "end_header\n0 0 0 0 0 " + values + "\n1 0 0 1 0 " + values + "\n1 1 0 1 1 " + values +
         "\n0 1 0 0 1 " + values + "\n3 0 1 2 " + first + "\n3 0 2 3 " + second + "\n";
}

const std::string rgb = "property TYPE red\nproperty TYPE green\nproperty TYPE blue\n";

std::string rgb_of(const std::string& type) {
  std::string lines = rgb;
  for (std::size_t at; (at = lines.find("TYPE")) != std::string::npos;) lines.replace(at, 4, type);
  return lines;
}

MeshFile read(const std::string& text) {
  return read_mesh(text, "a.ply", load_from_memory({{"tex/a.png", png}, {"b.png", png + "b"}}));
}

nlohmann::json glb_of(const MeshFile& file) {
  const std::string glb = format_mesh(file.mesh, "glb", {.scene = file.scene});
  return nlohmann::json::parse(glb.substr(20, load<std::uint32_t>(glb.data() + 12)));
}

bool warns(const MeshFile& file, const std::string& words) {
  return std::any_of(file.warnings.begin(), file.warnings.end(), [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

TEST(PlyTextures, AreMaterialsInGlb) {
  const MeshFile file = read(square("comment TextureFile tex\\a.png\n"));
  EXPECT_TRUE(file.warnings.empty());
  EXPECT_EQ(file.mesh.material_names, (std::vector<std::string>{"a"}));
  const nlohmann::json glb = glb_of(file);
  EXPECT_EQ(glb["images"].size(), 1u);
  EXPECT_EQ(glb["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  ASSERT_EQ(file.looks.size(), 1u);
  EXPECT_EQ(file.looks[0].base_picture.file, "tex/a.png");
}

TEST(PlyTextures, GoToTheFacesThatNameThem) {
  const std::string both = "comment TextureFile tex/a.png\ncomment TextureFile b.png\n";
  const MeshFile file = read(square(both, "", "", "property int texnumber\n", "1", "0"));
  EXPECT_EQ(file.mesh.material_names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(file.mesh.face_materials, (std::vector<std::int32_t>{1, 0}));
  EXPECT_EQ(glb_of(file)["images"].size(), 2u);
  EXPECT_TRUE(warns(read(square(both)), "no face says which is its own"));
}

TEST(PlyTextures, AreFoundFromWhereTheMeshIsWritten) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "in" / "tex");
  fs::create_directories(folder.path() / "out");
  std::ofstream(folder.path() / "in" / "tex" / "a.png", std::ios::binary) << png;
  std::ofstream(folder.path() / "in" / "a.ply") << square("comment TextureFile tex/a.png\n");
  const MeshFile file = read_mesh_file(folder.path() / "in" / "a.ply");
  write_mesh(folder.path() / "out" / "b.ply", file.mesh, {.scene = file.scene});
  const std::string moved = read_text(folder.path() / "out" / "b.ply");
  EXPECT_NE(moved.find("comment TextureFile ../in/tex/a.png\n"), std::string::npos);
  write_mesh(folder.path() / "in" / "b.ply", file.mesh, {.scene = file.scene});
  EXPECT_NE(read_text(folder.path() / "in" / "b.ply").find("comment TextureFile tex/a.png\n"),
            std::string::npos);
  const MeshFile back = read_mesh_file(folder.path() / "in" / "b.ply");
  ASSERT_EQ(back.looks.size(), 1u);
  EXPECT_EQ(back.looks[0].base_picture.file, "tex/a.png");
}

TEST(PlyTextures, ThatAreNotThereAreNamed) {
  EXPECT_TRUE(warns(read(square("comment TextureFile gone.png\n")),
                    "texture 'gone.png' cannot be read: not found"));
  EXPECT_TRUE(
      warns(read(square("comment TextureFile ../gone.png\n")), "not in the model's folder"));
}

TEST(PlyColours, KeepAsManyBitsAsTheyHave) {
  for (const auto& [type, color, written] :
       std::vector<std::array<std::string, 3>>{{"uchar", "100 200 7", "uchar"},
                                               {"ushort", "100 200 60000", "ushort"},
                                               {"float", "0.1234567 0.5 1", "float"}}) {
    const MeshFile file = read(square("", rgb_of(type), color));
    const std::string bytes = format_mesh(file.mesh, "ply", {.scene = file.scene});
    EXPECT_NE(bytes.find("property " + written + " red"), std::string::npos) << type;
    EXPECT_EQ(read(bytes).mesh.vertex_colors, file.mesh.vertex_colors) << type;
  }
  SurfaceMesh mesh = rich_mesh();
  EXPECT_NE(format_mesh(mesh, "ply").find("property uchar red"), std::string::npos);
  mesh.vertex_colors[0][0] = 0.1234567f;
  EXPECT_EQ(read(format_mesh(mesh, "ply")).mesh.vertex_colors[0], mesh.vertex_colors[0]);
}

TEST(PlyColours, OfCutBytesStayBytes) {
  MeshFile file = read(square("", rgb_of("uchar"), "100 200 7"));
  file.mesh.vertex_colors[1][0] = 0.1234567f;  // as if interpolated
  EXPECT_NE(format_mesh(file.mesh, "ply", {.scene = file.scene}).find("property uchar red"),
            std::string::npos);
}

TEST(PlyColours, BrighterThanWhiteAreBoundedWithAWarning) {
  const MeshFile file = read(square("", rgb_of("float"), "5 0.25 0"));
  EXPECT_EQ(file.mesh.vertex_colors[0], (Color{1, 0.25f, 0, 1}));
  EXPECT_TRUE(warns(file, "4 channels of colours go beyond 0 to 1"));
}

TEST(PlyHeader, ObjInfoComesBack) {
  const MeshFile file = read(square("obj_info num_cols 512\n"));
  const std::string bytes = format_mesh(file.mesh, "ply", {.scene = file.scene});
  EXPECT_NE(bytes.find("\nobj_info num_cols 512\n"), std::string::npos);
}

TEST(PlyRows, ThatAreNotDeclaredAreCounted) {
  EXPECT_TRUE(warns(read(square("") + "3 0 1 2\n"), "8 bytes after the last row are not read"));
  EXPECT_TRUE(read(square("") + "\n \n").warnings.empty());
  const std::string binary = format_mesh(rich_mesh(), "ply");
  EXPECT_TRUE(read(binary).warnings.empty());
  EXPECT_TRUE(warns(read(binary + "abc"), "3 bytes after the last row"));
}

TEST(PlyNumbers, ThatAreNotFiniteAreMendedWhereTheyAreNoPlaces) {
  for (const char* broken : {"nan", "inf", "-nan(ind)", "1.#QNAN", "1e999"}) {
    const MeshFile file =
        read(square("",
                    "property float quality\nproperty float nx\nproperty float ny\n"
                    "property float nz\n" +
                        rgb_of("float"),
                    std::string(broken) + " " + broken + " 0 0 1 " + broken + " 0"));
    EXPECT_EQ(find_attribute(file.mesh.vertex_attributes, "quality")->values,
              (std::vector<double>(4, 0)))
        << broken;
    EXPECT_EQ(file.mesh.corner_normals[0], Vec3(0, 0, 1));
    EXPECT_EQ(file.mesh.vertex_colors[0], (Color{1, 0, 0, 1}));
    EXPECT_TRUE(warns(file, "not finite numbers are 0: 4 of 'quality', 4 of 'nx', 4 of 'green'"));
  }
}

}  // namespace
}  // namespace craze
