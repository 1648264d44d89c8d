// What readers leave out or mend is named, and nothing else is.
#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "craze/io/files/sibling_files.h"
#include "craze/read_mesh.h"
#include "craze/write_mesh.h"
#include "io/gltf/scene/scene_file.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The warnings, one line each.
std::string warnings_of(const std::string& bytes, const std::string& name) {
  std::string all;
  for (const std::string& warning : read_mesh(bytes, name).warnings) all += warning + "\n";
  return all;
}

/// What is said when a file of that kind is written.
std::string lost_in(const std::string& format, const MeshFile& file) {
  std::string all;
  MeshFileOptions options{.scene = file.scene};
  options.warn = [&](const std::string& sentence) { all += sentence + "\n"; };
  format_mesh(file.mesh, format, options);
  return all;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(LeftOut, ObjNamesWhatItsVerticesAndFacesSayBesides) {
  const auto said = [](const std::string& lines) { return warnings_of(square + lines, "a.obj"); };
  EXPECT_EQ(said("f 1 2 3\n"), "");
  EXPECT_EQ(said("f 1 2\nf 3\nf 1 2 3\n"), "2 faces of fewer than three corners are left out\n");
  EXPECT_TRUE(holds(said("v 0 0 1 0.5\nf 1 2 5\n"), "1 vertices have weights"));
  EXPECT_EQ(said("v 0 0 1 1\nf 1 2 5\n"), "") << "a weight of 1 is none";
  EXPECT_TRUE(holds(said("vt 0 0 0.5\nf 1/1 2/1 3/1\n"), "third number"));
  EXPECT_TRUE(holds(said("s 1\nf 1 2 3\ns off\nf 1 3 4\n"), "smoothing groups"));
  EXPECT_EQ(said("s 1\nf 1 2 3\nf 1 3 4\n"), "") << "all is smooth";
  EXPECT_EQ(said("vn 0 0 1\ns off\nf 1//1 2//1 3//1\n"), "") << "normals say it";
}

TEST(LeftOut, ObjMendsNumbersThatAreNotFinite) {
  const MeshFile file = read_mesh(
      "v 0 0 0 1 0 0\nv 1 0 0 nan 0 0\nv 1 1 0 0 1 0\nvt nan 0\nvt 1 0\nvn nan nan nan\n"
      "vn 0 inf 1\nf 1/1/1 2/2/2 3/2/1\n",
      "a.obj");
  EXPECT_EQ(file.mesh.corner_normals, std::vector<Vec3>(3, Vec3(0, 0, 1)));
  EXPECT_EQ(file.mesh.corner_uvs[0], Vec2(0, 0));
  EXPECT_EQ(file.mesh.corner_uvs[1], Vec2(1, 0));
  EXPECT_EQ(file.mesh.vertex_colors[1], (Color{1, 1, 1, 1}));
  EXPECT_EQ(file.warnings.size(), 3u);
}

TEST(LeftOut, OffKeepsAlphaAndCountsWhatFollows) {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 ";
  EXPECT_EQ(warnings_of(off + "1 0 0\n", "a.off"), "");
  const MeshFile clear = read_mesh(off + "255 0 0 128\n", "a.off");
  ASSERT_NE(find_attribute(clear.mesh.face_attributes, "alpha"), nullptr);
  EXPECT_EQ(find_attribute(clear.mesh.face_attributes, "alpha")->values[0], 128);
  const MeshFile opaque = read_mesh(off + "0.5 0 0 1\n", "a.off");
  EXPECT_EQ(find_attribute(opaque.mesh.face_attributes, "alpha"), nullptr);
  EXPECT_EQ(warnings_of(off + "\n3 0 1 2\n", "a.off"),
            "8 bytes after the last face are not read\n");
  const MeshFile broken =
      read_mesh("NOFF\n3 1 0\n0 0 0 nan 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n", "a.off");
  EXPECT_EQ(broken.mesh.corner_normals[0], Vec3(0, 0, 1));
  EXPECT_EQ(broken.warnings.size(), 1u);
}

TEST(LeftOut, StlNamesItsSolidsAndItsHeader) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  const MeshFile ascii =
      read_mesh("solid my part\n" + facet + "endsolid\nsolid\n" + facet + "endsolid\n", "a.stl");
  EXPECT_TRUE(holds(lost_in("ply", ascii), "names of solids my part"));
  std::string binary = format_mesh(rich_mesh(), "stl");
  EXPECT_EQ(lost_in("ply", read_mesh(binary, "a.stl")), "") << "our own says nothing";
  binary.replace(0, 30, "made by hand, COLOR=abcd      ");
  EXPECT_TRUE(holds(lost_in("ply", read_mesh(binary, "a.stl")), "the header's text made by hand"));
}

/// A GLB of one triangle whose node and material are as given.
SceneFile triangle(const Json& node, const Json& material) {
  SceneFile file;
  file.json["asset"].erase("extras");
  const std::size_t places = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  Json primitive{{"attributes", {{"POSITION", places}}}};
  if (!material.is_null()) {
    file.json["materials"] = Json::array({material});
    primitive["material"] = 0;
  }
  file.json["meshes"].push_back({{"primitives", Json::array({primitive})}});
  Json own = node;
  own["mesh"] = 0;
  file.json["nodes"].push_back(own);
  file.json["scenes"][0]["nodes"].push_back(0);
  return file;
}

TEST(LeftOut, GltfSaysNothingWhereNothingIsLost) {
  const auto lost = [](const std::string& format, const Json& node, const Json& material) {
    return lost_in(format, read_mesh(triangle(node, material).bytes(), "a.glb"));
  };
  EXPECT_EQ(lost("ply", Json::object(), nullptr), "");
  EXPECT_TRUE(holds(lost("ply", {{"name", "Cup"}}, nullptr), "name of the node Cup"));
  EXPECT_EQ(lost("obj", {{"name", "Cup"}}, nullptr), "");
  for (const char* format : {"obj", "usda"}) {
    EXPECT_EQ(lost(format, Json::object(), Json::object()), "") << format;
    EXPECT_EQ(lost(format, Json::object(), {{"name", "m"}}), "") << format;
    EXPECT_EQ(lost(format, Json::object(),
                   Json::parse(R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}})")),
              "");
    EXPECT_TRUE(
        holds(lost(format, Json::object(), Json::parse(R"({"extensions": {"KHR_materials_clearcoat":
                                        {"clearcoatFactor": 1}}})")),
              "what materials have besides"));
    EXPECT_TRUE(holds(
        lost(format, Json::object(), Json::parse(R"({"extensions": {"KHR_materials_unlit": {}}})")),
        "what materials have besides"));
  }
  const Json metal = Json::parse(R"({"pbrMetallicRoughness": {"metallicFactor": 0.5}})");
  EXPECT_TRUE(holds(lost("obj", Json::object(), metal), "what materials have besides"));
  EXPECT_EQ(lost("usda", Json::object(), metal), "");
}

TEST(LeftOut, GltfNamesCopyrightExtrasAndExtensions) {
  SceneFile file = triangle({{"extras", {{"door", 1}}}}, nullptr);
  Json& primitive = file.json["meshes"][0]["primitives"][0];
  primitive["extensions"]["KHR_materials_variants"] = {{"mappings", Json::array()}};
  file.json["meshes"][0]["extras"] = {{"targetNames", {"smile"}}};
  file.json["extensions"]["KHR_xmp_json_ld"] = {{"packets", Json::array()}};
  file.json["asset"] = {{"version", "2.0"}, {"copyright", "by me"}};
  const MeshFile read = read_mesh(file.bytes(), "a.glb");
  for (const char* format : {"ply", "obj", "stl", "usda"}) {
    EXPECT_TRUE(holds(lost_in(format, read),
                      "copyright by me, extensions KHR_xmp_json_ld, 1 extras, extensions of meshes "
                      "KHR_materials_variants"))
        << lost_in(format, read);
  }
  // Another surface, shown by the same nodes.
  EXPECT_EQ(
      lost_in("glb", read),
      "not kept of the input, since .glb of another surface than the input's has no place for "
      "them: extensions of meshes KHR_materials_variants\n");
}

TEST(LeftOut, GltfCountsWhatMakesNoTriangle) {
  SceneFile file = triangle(Json::object(), nullptr);
  const std::size_t four = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  file.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", four}}}});
  file.json["meshes"][0]["primitives"].push_back(
      {{"attributes", {{"POSITION", four}}}, {"mode", 7}});
  EXPECT_EQ(warnings_of(file.bytes(), "a.glb"),
            "1 vertices at the ends of lists of triangles make none\n"
            "1 primitives of an unknown mode are not read\n");
  const std::string plain = triangle(Json::object(), nullptr).bytes();
  EXPECT_EQ(warnings_of(plain, "a.glb"), "");
  EXPECT_EQ(warnings_of(plain + "abcd", "a.glb"),
            "4 bytes after the end of the GLB are not read\n");
}

TEST(LeftOut, GltfMendsNumbersThatAreNotFinite) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::pair<const char*, std::size_t>> kinds{
      {"NORMAL", 3}, {"TEXCOORD_0", 2}, {"COLOR_0", 4}, {"TANGENT", 4}, {"_FOO", 1}};
  for (const auto& [key, n] : kinds) {
    SceneFile file = triangle(Json::object(), nullptr);
    std::vector<float> numbers(3 * n, 0.5f);
    numbers[0] = nan;
    const char* types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    file.json["meshes"][0]["primitives"][0]["attributes"][key] =
        file.add(numbers, types[n], 5126, n);
    const MeshFile read = read_mesh(file.bytes(), "a.glb");
    ASSERT_EQ(read.warnings.size(), 1u) << key;
    EXPECT_EQ(read.warnings[0], std::string("numbers that are not finite are mended in ") + key);
    // What is written again is mended too.
    const SurfaceOrigin origin = [&] {
      SurfaceOrigin whole;
      whole.face = {0};
      for (int c = 0; c < 3; ++c) whole.weights.push_back(Vec3::Unit(c));
      whole.wall_begin = 1;
      return whole;
    }();
    MeshFileOptions options{.scene = read.scene};
    options.origin = &origin;
    EXPECT_TRUE(read_mesh(format_mesh(read.mesh, "glb", options), "b.glb").warnings.empty()) << key;
  }
}

TEST(FilesBeside, WaysThatStayInsideAreFollowed) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "sub");
  std::ofstream(folder.path() / "b%41.bin") << "literal";
  std::ofstream(folder.path() / "c d.bin") << "spaced";
  const Context context;
  const FileLoader load = load_from_folder(folder.path(), context);
  EXPECT_EQ(load("./sub/../c%20d.bin"), "spaced");
  EXPECT_EQ(load("b%41.bin"), "literal");
  for (const char* out : {"../x.bin", "sub/../../x.bin", "%2e%2e/x.bin"}) {
    EXPECT_TRUE(holds(message_of([&] { load(out); }), "for safety no other file is opened")) << out;
  }
}

TEST(FilesBeside, DataUrisMayBeInCapitals) {
  SceneFile file = triangle(Json::object(), nullptr);
  Json json = file.json;
  json["accessors"][0].erase("min");
  json["accessors"][0].erase("max");
  json["buffers"] =
      Json::array({{{"byteLength", 36},
                    {"uri", "DATA:application/octet-stream;BASE64," + std::string(48, 'A')}}});
  EXPECT_EQ(read_mesh(json.dump(), "a.gltf").mesh.triangles.size(), 1u);
}

}  // namespace
}  // namespace craze
