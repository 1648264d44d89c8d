#include "craze/io/obj/mtl.h"

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "craze/io/bytes/byte_order.h"
#include "craze/io/obj/obj_scene.h"
#include "craze/read_mesh.h"
#include "craze/write_mesh.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

namespace fs = std::filesystem;
using Numbers = std::array<double, 3>;

constexpr const char* triangle =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\n"
    "f 1/1 2/2 3/3\n";
const std::string png = "\x89PNG\r\n\x1a\n and so on";

MtlMaterial only(const std::string& lines) {
  return parse_mtl("newmtl m\n" + lines).at(0);
}

/// A model whose one material has these lines, beside a picture "tex/a.png".
MeshFile read(const std::string& library) {
  return read_mesh(triangle, "a.obj",
                   load_from_memory({{"a.mtl", library}, {"tex/a.png", png}, {"no.tga", "tga"}}));
}

nlohmann::json material_in_glb(const MeshFile& file) {
  const std::string glb = format_mesh(file.mesh, "glb", {.scene = file.scene});
  return nlohmann::json::parse(
      glb.substr(20, load<std::uint32_t>(glb.data() + 12)))["materials"][0];
}

bool warns(const MeshFile& file, const std::string& words) {
  return std::any_of(file.warnings.begin(), file.warnings.end(), [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

TEST(Mtl, LibrariesMayHaveAMarkOrBeInUtf16) {
  std::string wide = "\xff\xfe";
  for (const char c : std::string("newmtl m\nKd 1 0 0\n")) wide += {c, '\0'};
  for (const std::string& library : {std::string("\xef\xbb\xbfnewmtl m\nKd 1 0 0\n"), wide}) {
    const MeshFile file = read(library);
    ASSERT_EQ(file.looks.size(), 1u);
    EXPECT_EQ(file.looks[0].base_color, (Color{1, 0, 0, 1}));
    EXPECT_TRUE(file.warnings.empty());
  }
}

TEST(Mtl, NumbersAreReadAlikeInEveryLocale) {
  const char* set = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8"}) {
    if (!set) set = std::setlocale(LC_NUMERIC, name);
  }
  if (!set) GTEST_SKIP() << "no locale with a decimal comma is installed";
  const auto material = only("Kd 0.25 0.5 0.75\nd 0.5\nmap_Kd -s 2.5 2.5 1 -o 0.5 0 0 a.png\n");
  const auto huge = read_mesh("v 1.5e-400 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  std::setlocale(LC_NUMERIC, "C");
  EXPECT_EQ(material.color, (Numbers{0.25, 0.5, 0.75}));
  EXPECT_EQ(material.opacity, 0.5);
  EXPECT_EQ(material.color_picture.name, "a.png");
  EXPECT_EQ(material.color_picture.scale[0], 2.5);
  EXPECT_EQ(huge.mesh.positions[0], Vec3(0, 0, 0));
}

TEST(Mtl, ColoursAreUnderstoodInAllTheirForms) {
  EXPECT_EQ(only("Kd 0.5\n").color, (Numbers{0.5, 0.5, 0.5})) << "one number is grey";
  EXPECT_EQ(only("KD 1 \\\n0 0.5 # red\n").color, (Numbers{1, 0, 0.5}));
  const Numbers white = only("Kd xyz 0.9505 1 1.089\n").color;
  for (const double channel : white) EXPECT_NEAR(channel, 1, 1e-3);
  EXPECT_EQ(only("d -halo 0.25\n").opacity, 0.25);
  EXPECT_EQ(only("Tr 0.25\n").opacity, 0.75);
}

TEST(Mtl, WhatIsNoColourIsNamedAndStaysPlain) {
  for (const char* line : {"Kd nan 0 0", "Kd spectral a.rfl 1", "Kd red", "Kd"}) {
    const MeshFile file = read(std::string("newmtl m\n") + line + "\n");
    EXPECT_TRUE(warns(file, "not understood and stay plain: 'm'")) << line;
    const auto material = material_in_glb(file);
    EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"],
              nlohmann::json({0.8, 0.8, 0.8, 1.0}));
  }
  EXPECT_TRUE(warns(read("newmtl m\nKd 255 0 0\n"), "out of range, which are bounded: 'm'"));
  EXPECT_TRUE(read("newmtl m\nKd 1 0 0\n").warnings.empty());
}

TEST(Mtl, PicturesAreFoundWhateverTheirNamesLookLike) {
  for (const char* name : {"tex\\a.png", "\"tex/a.png\"", ".\\tex\\a.png", "tex/a.png"}) {
    const MeshFile file = read("newmtl m\nKd 1 1 1\nmap_Kd " + std::string(name) + "\n");
    if (std::string(name).starts_with('.')) {  // a folder, not a list in memory, knows those
      EXPECT_EQ(file.looks[0].base_picture.file, "./tex/a.png");
      continue;
    }
    EXPECT_TRUE(file.warnings.empty()) << name;
    EXPECT_TRUE(material_in_glb(file)["pbrMetallicRoughness"].contains("baseColorTexture"));
  }
}

TEST(Mtl, PicturesThatCannotBeReadAreNamedWithTheReason) {
  EXPECT_TRUE(warns(read("newmtl m\nmap_Kd gone.png\n"), "'gone.png' (not found)"));
  EXPECT_TRUE(warns(read("newmtl m\nmap_Kd ../x.png\n"), "'../x.png' (not in the model's folder)"));
  EXPECT_TRUE(warns(read("newmtl m\nnorm C:\\x.png\n"), "'C:/x.png' (not in the model's folder)"));
  EXPECT_TRUE(warns(read("newmtl m\nmap_Kd no.tga\n"), "'no.tga' (no PNG or JPEG)"));
}

TEST(Mtl, MaterialsThatNoLibraryHasAreNamed) {
  EXPECT_TRUE(warns(read("newmtl n\nKd 1 0 0\n"), "materials that no library has: 'm'"));
}

TEST(Mtl, WhatGltfKnowsTooGoesThere) {
  const auto material =
      material_in_glb(read("newmtl m\nKd 1 1 1\nKe 2 1 0\nPr 0.25\nPm 1\nnorm -bm 0.5 tex/a.png\n"
                           "map_Ke tex/a.png\n"));
  const auto& surface = material["pbrMetallicRoughness"];
  EXPECT_EQ(surface["roughnessFactor"], 0.25);
  EXPECT_EQ(surface["metallicFactor"], 1.0);
  EXPECT_EQ(material["normalTexture"]["scale"], 0.5);
  EXPECT_EQ(material["emissiveFactor"], nlohmann::json({1.0, 0.5, 0.0}));
  EXPECT_EQ(material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 2.0);
  EXPECT_TRUE(material.contains("emissiveTexture"));
  const auto plain = material_in_glb(read("newmtl m\nKd 1 1 1\nKe 0 0 0\n"));
  EXPECT_FALSE(plain.contains("emissiveFactor"));
}

TEST(Mtl, WhatOtherFormatsCannotHoldIsNamedOnce) {
  const MeshFile file = read(
      "newmtl m\nKd 1 0 0\nKa 1 1 1\nKs 0.5 0.5 0.5\nNs 10\nillum 2\nTf 1 1 1\naniso 0\n"
      "map_Bump tex/a.png\nmap_d tex/a.png\n# by hand\n");
  std::vector<std::string> said;
  MeshFileOptions options{.scene = file.scene};
  options.warn = [&](const std::string& sentence) { said.push_back(sentence); };
  format_mesh(file.mesh, "glb", options);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("of the materials Ks map_Bump map_d"), std::string::npos) << said[0];
  said.clear();
  format_mesh(file.mesh, "obj", options);
  EXPECT_TRUE(said.empty()) << said[0];
}

TEST(Mtl, NamesOfOtherSystemsAreLeftAloneWhereAModelMoves) {
  ObjScene scene;
  scene.folder = "/models";
  scene.libraries = {"a.mtl"};
  scene.materials =
      "newmtl m\nmap_Kd C:\\tex\\one.png\nmap_Ks -mm 0 1 \"tex\\two.png\"\nbump /three.png\n";
  const ObjLibrary library = library_beside("/out/a.obj", scene, rich_mesh());
  EXPECT_NE(library.text.find("map_Kd C:\\tex\\one.png\n"), std::string::npos) << library.text;
  EXPECT_NE(library.text.find("map_Ks -mm 0 1 ../models/tex/two.png\n"), std::string::npos);
  EXPECT_NE(library.text.find("bump /three.png\n"), std::string::npos);
}

}  // namespace
}  // namespace craze
