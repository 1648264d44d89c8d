// What an OBJ file refers to, kept through being written again.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "craze/io/bytes/byte_order.h"
#include "craze/io/obj/mtl.h"
#include "craze/io/obj/obj_scene.h"
#include "craze/write_mesh.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

namespace fs = std::filesystem;

constexpr const char* library =
    "newmtl clay\nKd 1 0.5 0.25\nd 0.5\nmap_Kd -s 2 2 2 -mm 0 1 tex/clay one.png\n"
    "bump tex/bump.png\nnewmtl plain\nillum 2\n";
constexpr const char* cup =
    "mtllib cup.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\no cup\ng rim\nusemtl clay\nf 1 2 3\n"
    "g foot\nusemtl plain\nf 1 3 2\n";
constexpr const char* picture = "\x89PNG and so on";

void write(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A folder "in" with the cup, its library and its pictures, and an empty folder "out".
struct Shelf {
  TemporaryFolder folder;
  fs::path in, out;

  Shelf() : in(folder.path() / "in"), out(folder.path() / "out") {
    fs::create_directories(in / "tex");
    fs::create_directories(out);
    write(in / "cup.obj", cup);
    write(in / "cup.mtl", library);
    write(in / "tex" / "clay one.png", picture);
  }
  MeshFile read() const { return read_mesh_file(in / "cup.obj"); }
};

TEST(Mtl, ColourOpacityAndPictureAreUnderstood) {
  const auto materials = parse_mtl(library);
  ASSERT_EQ(materials.size(), 2u);
  EXPECT_EQ(materials[0].name, "clay");
  EXPECT_EQ(materials[0].color, (std::array{1.0, 0.5, 0.25}));
  EXPECT_EQ(materials[0].opacity, 0.5);
  EXPECT_EQ(materials[0].color_picture.name, "tex/clay one.png");
  EXPECT_EQ(materials[1].color_picture.name, "");
}

TEST(Mtl, PicturesRepeatUnlessTheyAreClamped) {
  EXPECT_FALSE(parse_mtl("newmtl a\nmap_Kd a.png\n")[0].color_picture.is_clamped);
  const auto clamped = parse_mtl("newmtl a\nmap_Kd -clamp on -s 2 2 1 a.png\n");
  EXPECT_TRUE(clamped[0].color_picture.is_clamped);
  EXPECT_EQ(clamped[0].color_picture.name, "a.png");
  EXPECT_FALSE(
      parse_mtl("newmtl a\nmap_Kd -clamp on a.png\nmap_Kd b.png\n")[0].color_picture.is_clamped);
}

TEST(Mtl, OpacityIsNeverSaidByTrWhereDSaysIt) {
  for (const char* text : {"newmtl a\nTr 1\nd 0.75\n", "newmtl a\nd 0.75\nTr 1\n",
                           "newmtl b\nd 0\nnewmtl a\nTr 0.25\n"}) {
    EXPECT_EQ(parse_mtl(text).back().opacity, 0.75) << text;
  }
  EXPECT_EQ(parse_mtl("newmtl a\nd 7\n")[0].opacity, 1);
}

TEST(ObjScene, ObjectsGroupsAndTheLibraryAreWrittenAgain) {
  const Shelf shelf;
  const MeshFile file = shelf.read();
  EXPECT_TRUE(file.warnings.empty());
  write_mesh(shelf.in / "cracked.obj", file.mesh, {.scene = file.scene});
  const std::string text = read_text(shelf.in / "cracked.obj");
  EXPECT_TRUE(holds(text, "mtllib cup.mtl\n")) << "still in reach";
  EXPECT_FALSE(fs::exists(shelf.in / "cracked.mtl"));
  EXPECT_TRUE(holds(text, "o cup\ng rim\nusemtl clay\n"));
  EXPECT_TRUE(holds(text, "g foot\nusemtl plain\n"));
  EXPECT_EQ(text.find("o cup"), text.rfind("o cup")) << "one object stays one";
}

TEST(ObjScene, FacesOfOneObjectAreTogetherHoweverTheyCome) {
  SurfaceMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(5, {0, 1, 2});
  mesh.object_names = {"A", "B/rim", "B", "rim"};
  mesh.face_objects = {0, 1, 0, 2, 3};
  ObjScene scene;
  scene.objects = {{"A", ""}, {"B", "rim"}, {"B", ""}, {"", "rim"}};
  const auto shared = std::make_shared<const ObjScene>(scene);
  const std::string f = "f 1 2 3\n";
  EXPECT_TRUE(holds(format_mesh(mesh, "obj", {.scene = shared}),
                    "g rim\n" + f + "o A\n" + f + f + "o B\n" + f + "g rim\n" + f));
  mesh.object_names = {"A", "B", "B", ""};
  EXPECT_TRUE(holds(format_mesh(mesh, "obj"), "o A\n" + f + f + "o B\n" + f + "o B\n" + f));
}

TEST(ObjScene, ElsewhereALibraryLiesBesideTheMeshAndFindsItsPictures) {
  const Shelf shelf;
  const MeshFile file = shelf.read();
  write_mesh(shelf.out / "cracked.obj", file.mesh, {.scene = file.scene});
  EXPECT_TRUE(holds(read_text(shelf.out / "cracked.obj"), "mtllib cracked.mtl\n"));
  const std::string text = read_text(shelf.out / "cracked.mtl");
  EXPECT_TRUE(holds(text, "illum 2\n")) << "what is not understood is kept";
  EXPECT_TRUE(holds(text, "bump ../in/tex/bump.png\n"));
  const std::string moved = parse_mtl(text)[0].color_picture.name;
  EXPECT_EQ(read_text(shelf.out / moved), picture);
}

TEST(ObjScene, WallsJoinTheLibraryAndTheFilesOwnIsNeverOverwritten) {
  const Shelf shelf;
  MeshFile file = shelf.read();
  file.mesh.material_names.emplace_back("crack_wall");
  file.mesh.face_materials[1] = 2;
  write_mesh(shelf.in / "cup.obj", file.mesh, {.scene = file.scene});
  EXPECT_EQ(read_text(shelf.in / "cup.mtl"), library);
  EXPECT_TRUE(holds(read_text(shelf.in / "cup.obj"), "mtllib cup_cracks.mtl\n"));
  EXPECT_TRUE(holds(read_text(shelf.in / "cup_cracks.mtl"), "newmtl crack_wall\n"));
}

TEST(ObjScene, AGlbHasTheColoursAndPicturesOfTheLibrary) {
  const Shelf shelf;
  const MeshFile file = shelf.read();
  const std::string glb = format_mesh(file.mesh, "glb", {.scene = file.scene});
  const auto json = nlohmann::json::parse(glb.substr(20, load<std::uint32_t>(glb.data() + 12)));
  const auto& material = json["materials"][0]["pbrMetallicRoughness"];
  EXPECT_EQ(json["materials"][0]["name"], "clay");
  EXPECT_EQ(material["baseColorFactor"], nlohmann::json({1.0, 0.5, 0.25, 0.5}));
  const auto& image = json["images"][json["textures"][0]["source"].get<std::size_t>()];
  const auto& view = json["bufferViews"][image["bufferView"].get<std::size_t>()];
  EXPECT_TRUE(holds(glb, std::string(picture)));
  EXPECT_EQ(view["byteLength"], std::string(picture).size());
}

TEST(ObjScene, AGlbHasANodePerObject) {
  const Shelf shelf;
  const MeshFile file = shelf.read();
  const std::string glb = format_mesh(file.mesh, "glb", {.scene = file.scene});
  const auto json = nlohmann::json::parse(glb.substr(20, load<std::uint32_t>(glb.data() + 12)));
  ASSERT_EQ(json["nodes"].size(), 2u);
  EXPECT_EQ(json["nodes"][0]["name"], "cup/rim");
  EXPECT_EQ(json["nodes"][1]["name"], "cup/foot");
  const MeshFile back = read_mesh(glb, "cup.glb");
  EXPECT_EQ(back.mesh.positions.size(), 6u);
  EXPECT_EQ(back.mesh.object_names, file.mesh.object_names);
}

TEST(ObjScene, PicturesShowTheLibrarysLooks) {
  const Shelf shelf;
  const MeshFile file = shelf.read();
  ASSERT_EQ(file.looks.size(), 2u);
  EXPECT_EQ(file.looks[0].base_color, (Color{1, 0.5f, 0.25f, 0.5f}));
  EXPECT_EQ(file.looks[0].base_picture.file, "tex/clay one.png");
  EXPECT_EQ(file.looks[0].base_picture.place(0, 0), 2) << "-s";
  EXPECT_EQ(file.looks[1].base_picture.file, "");
}

/// A triangle with a material "paint" twice, one with a picture that only the input holds.
struct Painted {
  SurfaceMesh mesh;
  std::vector<MaterialLook> looks = std::vector<MaterialLook>(3);

  Painted() {
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}};
    mesh.face_materials = {0, 1, 3};
    mesh.material_names = {"paint", "paint", "sky", "crack_wall"};
    looks[0].base_color = {0.5f, 0.25f, 1, 0.5f};
    looks[1].base_picture.bytes = std::make_shared<const std::string>(picture);
    looks[1].base_picture.place << 2, 0, 0.5, 0, 3, -1;
    looks[2].base_picture.file = "../in/sky one.png";
  }
};

TEST(LooksLibrary, HoldsColoursAndPicturesOfAFileOfAnotherKind) {
  const Shelf shelf;
  const Painted painted;
  write_mesh(shelf.out / "a.obj", painted.mesh, {.looks = &painted.looks});
  const std::string text = read_text(shelf.out / "a.obj");
  EXPECT_TRUE(holds(text, "mtllib a.mtl\n"));
  EXPECT_TRUE(holds(text, "usemtl paint_2\n")) << "two materials of one name stay two";
  const MeshFile back = read_mesh_file(shelf.out / "a.obj");
  ASSERT_EQ(back.warnings.size(), 1u);
  EXPECT_TRUE(holds(back.warnings[0], "'../in/sky one.png' (not in the model's folder)"));
  ASSERT_EQ(back.looks.size(), 3u) << "as far as faces use them";
  EXPECT_EQ(back.looks[0].base_color, painted.looks[0].base_color);
  EXPECT_EQ(back.looks[1].base_picture.place, painted.looks[1].base_picture.place);
  EXPECT_EQ(read_text(shelf.out / back.looks[1].base_picture.file), picture);
  EXPECT_LT(back.looks[2].base_color[0], 0.5f) << "walls are dark";
  const auto materials = parse_mtl(read_text(shelf.out / "a.mtl"));
  ASSERT_EQ(materials.size(), 4u);
  EXPECT_EQ(materials[2].color_picture.name, "../in/sky one.png");
}

TEST(LooksLibrary, IsNotWrittenWhereTheMeshCannotBe) {
  const Shelf shelf;
  const Painted painted;
  Context stopped;
  stopped.cancelled = [] { return true; };
  EXPECT_THROW(write_mesh(shelf.out / "a.obj", painted.mesh, {.looks = &painted.looks}, stopped),
               Cancelled);
  EXPECT_TRUE(fs::is_empty(shelf.out));
}

TEST(ObjScene, PicturesAreNamedWhereAFormatHasNoPlaceForThem) {
  const Shelf shelf;
  const MeshFile file = shelf.read();
  for (const char* format : {"ply", "stl", "glb"}) {
    std::string said;
    MeshFileOptions options{.scene = file.scene};
    options.warn = [&](const std::string& sentence) { said += sentence; };
    format_mesh(file.mesh, format, options);
    EXPECT_EQ(holds(said, "1 pictures of materials"), std::string(format) != "glb") << said;
  }
}

TEST(ObjScene, NamesNeverJoinTheNextLine) {
  SurfaceMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.face_materials = mesh.face_objects = {0};
  mesh.material_names = mesh.object_names = {"clay\\"};
  const std::string text = format_mesh(mesh, "obj");
  EXPECT_TRUE(holds(text, "o clay_\nusemtl clay_\nf 1 2 3\n")) << text;
  EXPECT_EQ(mtl_names(mesh), std::vector<std::string>{"clay_"});
}

TEST(ObjScene, ALibraryThatIsNotThereIsNamed) {
  const MeshFile file = read_mesh(cup, "cup.obj");
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_TRUE(holds(file.warnings[0], "cup.mtl"));
  EXPECT_EQ(file.mesh.material_names, (std::vector<std::string>{"clay", "plain"}));
}

}  // namespace
}  // namespace craze
