#include "craze/io/usd/usd.h"
#include "craze/io/usd/usd_text.h"

#include <gtest/gtest.h>

#include <set>

#include "craze/mesh/morph_animation.h"
#include "craze/shapes.h"
#include "io/io_test_tools.h"
#include "io/usd/usda_parser.h"

namespace craze {
namespace {

using test::parse_usda;
using test::UsdPrim;

/// Two triangles with everything that a mesh can have.
SurfaceMesh rich() {
  SurfaceMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.25}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.corner_uvs = {{0, 0}, {1, 0}, {1, 1}, {0.5, 0}, {1, 1}, {0, 1}};
  mesh.corner_normals.assign(6, Vec3(0, 0, 1));
  mesh.vertex_colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 0.5f}};
  mesh.material_names = {"two words", "2nd \"quoted\"", "crack_wall"};
  mesh.face_materials = {0, 2};
  mesh.vertex_attributes = {{"crack distance", 1, {0.5, 1, 2, 3}},
                            {"pull", 3, std::vector<double>(12, 0.25)}};
  mesh.face_attributes = {{"fragment", 1, {7, 8}}};
  return mesh;
}

const UsdPrim& surface(const UsdPrim& root) {
  return root.at("craze").at("surface");
}

TEST(Usda, StringsAreUtf8OnOneLine) {
  EXPECT_EQ(usd_string("T\u00fcr \\ \"\n"), "\"T\u00fcr \\\\ \\\" \"");
  EXPECT_EQ(usd_string("caf\xe9!\xc3"), "\"caf\ufffd!\ufffd\"");
}

TEST(Usda, HoldsTheTrianglesAndTheirPoints) {
  const SurfaceMesh mesh = rich();
  const UsdPrim root = parse_usda(format_mesh(mesh, "usda"));
  EXPECT_EQ(root.metadata.at("defaultPrim"), "\"craze\"");
  EXPECT_EQ(root.metadata.at("metersPerUnit"), "1");
  EXPECT_EQ(root.metadata.at("upAxis"), "\"Y\"");
  const UsdPrim& prim = surface(root);
  EXPECT_EQ(prim.type, "Mesh");
  EXPECT_EQ(prim.values.at("subdivisionScheme"), "\"none\"");
  EXPECT_EQ(prim.numbers("faceVertexCounts"), (std::vector<double>{3, 3}));
  EXPECT_EQ(prim.numbers("faceVertexIndices"), (std::vector<double>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(prim.numbers("points"), (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0.25, 0, 1, 0}));
  EXPECT_EQ(prim.numbers("extent"), (std::vector<double>{0, 0, 0, 1, 1, 0.25}));
}

TEST(Usda, CornersFindTheirUvsAndNormals) {
  const SurfaceMesh mesh = rich();
  const UsdPrim root = parse_usda(format_mesh(mesh, "usda"));
  const UsdPrim& prim = surface(root);
  const auto st = prim.numbers("primvars:st"), indices = prim.numbers("primvars:st:indices");
  ASSERT_EQ(indices.size(), 6u);
  for (std::size_t c = 0; c < 6; ++c) {
    const auto i = static_cast<std::size_t>(indices[c]);
    EXPECT_EQ(Vec2(st.at(2 * i), st.at(2 * i + 1)), mesh.corner_uvs[c]);
  }
  EXPECT_EQ(prim.interpolation.at("primvars:st"), "\"faceVarying\"");
  EXPECT_EQ(prim.types.at("primvars:st"), "texCoord2f[]");
  EXPECT_EQ(prim.numbers("primvars:normals:indices").size(), 6u);
}

TEST(Usda, ColorsAndAttributesArePrimvars) {
  const UsdPrim root = parse_usda(format_mesh(rich(), "usda"));
  const UsdPrim& prim = surface(root);
  EXPECT_EQ(prim.numbers("primvars:displayColor").size(), 12u);
  EXPECT_EQ(prim.numbers("primvars:displayOpacity")[3], 0.5);
  EXPECT_EQ(prim.numbers("primvars:crack_distance"), (std::vector<double>{0.5, 1, 2, 3}));
  EXPECT_EQ(prim.types.at("primvars:pull"), "float3[]");
  EXPECT_EQ(prim.numbers("primvars:fragment"), (std::vector<double>{7, 8}));
  EXPECT_EQ(prim.types.at("primvars:fragment"), "int[]");
  EXPECT_EQ(prim.interpolation.at("primvars:fragment"), "\"uniform\"");
}

TEST(Usda, AttributesNeverTakeTheNamesOfTheFormatsOwn) {
  SurfaceMesh mesh = rich();
  mesh.corner_uvs.clear();
  mesh.vertex_colors.clear();
  mesh.corner_normals.clear();
  mesh.vertex_attributes.clear();
  for (const char* name : {"st", "normals", "displayColor", "displayOpacity"}) {
    mesh.vertex_attributes.push_back({name, 1, {1, 2, 3, 4}});
  }
  const UsdPrim root = parse_usda(format_mesh(mesh, "usda"));
  const UsdPrim& prim = surface(root);
  for (const Attribute& a : mesh.vertex_attributes) {
    EXPECT_EQ(prim.types.count("primvars:" + a.name), 0u) << a.name;
    EXPECT_EQ(prim.numbers("primvars:" + a.name + "_1"), a.values);
  }
}

TEST(Usda, TypesOfAttributesGoByTheirNames) {
  SurfaceMesh mesh = rich();
  mesh.vertex_attributes = {{"crack_time", 1, {1, 2, 3, 4}}, {"id", 1, {123456789, 0, 0, 0.5}}};
  const UsdPrim root = parse_usda(format_mesh(mesh, "usda"));
  const UsdPrim& prim = surface(root);
  EXPECT_EQ(prim.types.at("primvars:crack_time"), "float[]") << "whole or not";
  EXPECT_EQ(prim.types.at("primvars:id"), "double[]") << "a float would round it";
  EXPECT_EQ(prim.numbers("primvars:id")[0], 123456789);
}

TEST(Usda, MaterialsAreBoundToTheFacesThatHaveThem) {
  std::vector<MaterialLook> looks(3);
  looks[0].base_color = {0.5f, 0.25f, 0.125f, 1};
  looks[0].base_picture.file = "maps/brick wall.png";
  MeshFileOptions options;
  options.looks = &looks;
  SurfaceMesh mesh = rich();
  const UsdPrim root = parse_usda(format_mesh(mesh, "usda", options));
  const UsdPrim& scope = root.at("craze").at("Materials");
  ASSERT_EQ(scope.children.size(), 2u) << "one of the three is not used";
  const UsdPrim& brick = scope.at("two_words");
  EXPECT_EQ(brick.metadata.at("displayName"), "\"two words\"");
  EXPECT_EQ(brick.values.at("outputs:surface.connect"),
            "</craze/Materials/two_words/Surface.outputs:surface>");
  EXPECT_EQ(brick.at("Surface").values.at("inputs:diffuseColor.connect"),
            "</craze/Materials/two_words/BaseColor.outputs:rgb>");
  EXPECT_EQ(brick.at("BaseColor").values.at("inputs:file"), "@maps/brick wall.png@");
  EXPECT_EQ(brick.at("BaseColor").numbers("inputs:scale"),
            (std::vector<double>{0.5, 0.25, 0.125, 1}));
  EXPECT_EQ(brick.at("Uv").values.at("inputs:varname"), "\"st\"");
  EXPECT_EQ(surface(root).at("two_words").numbers("indices"), std::vector<double>{0});
  EXPECT_EQ(surface(root).at("crack_wall").numbers("indices"), std::vector<double>{1});
  EXPECT_EQ(surface(root).at("crack_wall").values.at("material:binding"),
            "</craze/Materials/crack_wall>");

  mesh.face_materials = {1, 1};
  const UsdPrim one = parse_usda(format_mesh(mesh, "usda"));
  EXPECT_EQ(surface(one).values.at("material:binding"), "</craze/Materials/_2nd__quoted_>");
  EXPECT_EQ(one.at("craze").at("Materials").at("_2nd__quoted_").metadata.at("displayName"),
            R"("2nd \"quoted\"")");
}

/// The material of a mesh whose one look this is.
UsdPrim material_of(const MaterialLook& look) {
  SurfaceMesh mesh = rich();
  mesh.material_names = {"one"};
  mesh.face_materials = {0, 0};
  const std::vector<MaterialLook> looks{look};
  MeshFileOptions options;
  options.looks = &looks;
  return parse_usda(format_mesh(mesh, "usda", options)).at("craze").at("Materials").at("one");
}

TEST(Usda, MaterialsHaveAllPicturesEachInItsColourSpace) {
  MaterialLook look;
  look.metallic = 0.25f;
  look.roughness = 0.5f;
  look.normal_strength = 0.75f;
  look.occlusion_strength = 0.25f;
  look.emission = {2, 1, 0, 1};
  look.metallic_roughness_picture.file = "mr.png";
  look.normal_picture.file = "normal.png";
  look.occlusion_picture.file = "ao.png";
  look.emission_picture.file = "glow.png";
  const UsdPrim material = material_of(look);
  const UsdPrim& surface = material.at("Surface");
  const auto expect_picture = [&](const std::string& name, const std::string& file,
                                  const std::string& space, std::vector<double> scale) {
    const UsdPrim& picture = material.at(name);
    EXPECT_EQ(picture.values.at("inputs:file"), "@" + file + "@");
    EXPECT_EQ(picture.values.at("inputs:sourceColorSpace"), "\"" + space + "\"");
    EXPECT_EQ(picture.numbers("inputs:scale"), scale) << name;
  };
  EXPECT_EQ(surface.values.at("inputs:metallic.connect"),
            "</craze/Materials/one/MetallicRoughness.outputs:b>");
  EXPECT_EQ(surface.values.at("inputs:roughness.connect"),
            "</craze/Materials/one/MetallicRoughness.outputs:g>");
  expect_picture("MetallicRoughness", "mr.png", "raw", {1, 0.5, 0.25, 1});
  EXPECT_EQ(surface.values.at("inputs:normal.connect"),
            "</craze/Materials/one/Normal.outputs:rgb>");
  expect_picture("Normal", "normal.png", "raw", {1.5, 1.5, 2, 1});
  EXPECT_EQ(material.at("Normal").numbers("inputs:bias"),
            (std::vector<double>{-0.75, -0.75, -1, 0}));
  EXPECT_EQ(surface.values.at("inputs:occlusion.connect"),
            "</craze/Materials/one/Occlusion.outputs:r>");
  expect_picture("Occlusion", "ao.png", "raw", {0.25, 0.25, 0.25, 1});
  EXPECT_EQ(material.at("Occlusion").numbers("inputs:bias")[0], 0.75);
  expect_picture("Emission", "glow.png", "sRGB", {2, 1, 0, 1});
  EXPECT_FALSE(surface.values.count("inputs:opacity"));
}

TEST(Usda, OpacityIsWhatCoversAndLetsNothingThrough) {
  using Alpha = MaterialLook::Alpha;
  MaterialLook look;
  look.base_color[3] = 0.5f;
  EXPECT_FALSE(material_of(look).at("Surface").values.count("inputs:opacity"));
  look.alpha = Alpha::blended;
  EXPECT_EQ(material_of(look).at("Surface").numbers("inputs:opacity")[0], 0.5);
  look.transmission = 0.75f;
  EXPECT_EQ(material_of(look).at("Surface").numbers("inputs:opacity")[0], 0.125);
  look.transmission_picture.file = "through.png";
  const UsdPrim through = material_of(look);
  EXPECT_EQ(through.at("Surface").values.at("inputs:opacity.connect"),
            "</craze/Materials/one/Transmission.outputs:r>");
  EXPECT_EQ(through.at("Transmission").numbers("inputs:scale")[0], -0.375);
  EXPECT_EQ(through.at("Transmission").numbers("inputs:bias")[0], 0.5);
  look.base_picture.file = "leaf.png";
  look.alpha = Alpha::cut;
  look.alpha_cutoff = 0.25f;
  const UsdPrim leaf = material_of(look);
  EXPECT_EQ(leaf.at("Surface").values.at("inputs:opacity.connect"),
            "</craze/Materials/one/BaseColor.outputs:a>");
  EXPECT_EQ(leaf.at("Surface").numbers("inputs:opacityThreshold")[0], 0.25);
  EXPECT_EQ(leaf.at("BaseColor").numbers("inputs:scale"), (std::vector<double>{1, 1, 1, 0.125}));
}

TEST(Usda, PicturesGoOnBeyondTheirBordersAsTheInputHasThem) {
  MaterialLook look;
  look.base_picture.file = "a.png";
  look.base_picture.wraps = {TextureWrap::clamp, TextureWrap::mirror};
  look.normal_picture.file = "b.png";
  const UsdPrim material = material_of(look);
  EXPECT_EQ(material.at("BaseColor").values.at("inputs:wrapS"), "\"clamp\"");
  EXPECT_EQ(material.at("BaseColor").values.at("inputs:wrapT"), "\"mirror\"");
  EXPECT_EQ(material.at("Normal").values.at("inputs:wrapS"), "\"repeat\"");
}

TEST(Usda, SaysWhereAlphaAndTransmissionBothHaveATexture) {
  std::vector<MaterialLook> looks(2);
  SurfaceMesh mesh = make_shape("plate?n=1");
  mesh.material_names = {"leaf", "glass"};
  mesh.face_materials = {0, 1};
  MaterialLook& glass = looks[1];
  glass.alpha = MaterialLook::Alpha::blended;
  glass.base_picture.file = "glass.png";
  glass.transmission = 0.5f;
  std::vector<std::string> warnings;
  MeshFileOptions options;
  options.looks = &looks;
  options.warn = [&](const std::string& w) { warnings.push_back(w); };
  format_mesh(mesh, "usda", options);
  EXPECT_TRUE(warnings.empty());
  glass.transmission_picture.file = "through.png";
  format_mesh(mesh, "usda", options);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("'glass'"), std::string::npos) << warnings[0];
}

TEST(Usda, PlacesOfPicturesAreScaledTurnedAndMoved) {
  MaterialLook look;
  look.base_picture.file = "a.png";
  const double turn = 0.5, sx = 2, sy = -3;
  look.base_picture.place << sx * std::cos(turn), -sy * std::sin(turn), 0.25, sx * std::sin(turn),
      sy * std::cos(turn), 0.75;
  const UsdPrim material = material_of(look);
  EXPECT_EQ(material.at("BaseColor").values.at("inputs:st.connect"),
            "</craze/Materials/one/BaseColorPlace.outputs:result>");
  const UsdPrim& place = material.at("BaseColorPlace");
  EXPECT_NEAR(place.numbers("inputs:rotation")[0], turn * 180 / 3.141592653589793, 1e-9);
  EXPECT_NEAR(place.numbers("inputs:scale")[0], sx, 1e-12);
  EXPECT_NEAR(place.numbers("inputs:scale")[1], sy, 1e-12);
  EXPECT_EQ(place.numbers("inputs:translation"), (std::vector<double>{0.25, 0.75}));
}

TEST(Usda, PicturesInMemoryAreWrittenBesideTheFile) {
  const TemporaryFolder folder;
  std::vector<MaterialLook> looks(3);
  looks[0].base_picture.bytes = looks[0].emission_picture.bytes =
      std::make_shared<const std::string>("\x89PNG\r\n\x1a\n and more");
  looks[0].emission = {1, 1, 1, 1};
  looks[0].normal_picture.bytes = std::make_shared<const std::string>("\xff\xd8\xff and more");
  MeshFileOptions options;
  options.looks = &looks;
  std::vector<std::string> said;
  options.warn = [&](const std::string& sentence) { said.push_back(sentence); };
  write_mesh(folder / "rich.usda", rich(), options);
  EXPECT_TRUE(said.empty());
  EXPECT_EQ(read_text(folder / "rich_1.png"), *looks[0].base_picture.bytes);
  EXPECT_EQ(read_text(folder / "rich_2.jpg"), *looks[0].normal_picture.bytes);
  const UsdPrim root = parse_usda(read_text(folder / "rich.usda"));
  const UsdPrim& material = root.at("craze").at("Materials").at("two_words");
  EXPECT_EQ(material.at("BaseColor").values.at("inputs:file"), "@rich_1.png@");
  EXPECT_EQ(material.at("Emission").values.at("inputs:file"), "@rich_1.png@");
  EXPECT_EQ(material.at("Normal").values.at("inputs:file"), "@rich_2.jpg@");
  format_mesh(rich(), "usda", options);
  EXPECT_EQ(said.size(), 1u) << "in memory, there is no beside";
}

TEST(Usda, PicturesInMemoryTakeNoFilesPlace) {
  const TemporaryFolder folder;
  std::vector<MaterialLook> looks(3);
  looks[0].base_picture.file = "rich_1.png";
  looks[0].normal_picture.bytes = std::make_shared<const std::string>("\x89PNG\r\n\x1a\n mine");
  std::ofstream(folder / "rich_1.png") << "the input's own";
  std::filesystem::create_directory(folder / "rich_2.png");
  MeshFileOptions options;
  options.looks = &looks;
  for (int run = 0; run < 2; ++run) {
    write_mesh(folder / "rich.usda", rich(), options);
    EXPECT_EQ(read_text(folder / "rich_1.png"), "the input's own");
    EXPECT_EQ(read_text(folder / "rich_3.png"), *looks[0].normal_picture.bytes);
    EXPECT_FALSE(std::filesystem::exists(folder / "rich_4.png"));
  }
}

TEST(Usda, PathsMayHaveAtSigns) {
  EXPECT_EQ(usd_asset("a b.png"), "@a b.png@");
  EXPECT_EQ(usd_asset("a@2.png"), "@@@a@2.png@@@");
  EXPECT_EQ(usd_asset("a@@@b\n.png"), "@@@a\\@@@b.png@@@");
}

TEST(Usda, NamesAreUnique) {
  SurfaceMesh mesh = rich();
  mesh.material_names = {"a b", "a-b", "crack_wall"};
  mesh.face_materials = {0, 1};
  mesh.vertex_attributes[1].name = "crack-distance";
  const UsdPrim root = parse_usda(format_mesh(mesh, "usda"));  // the parser refuses doubles
  EXPECT_EQ(root.at("craze").at("Materials").at("a_b_1").metadata.at("displayName"), "\"a-b\"");
  EXPECT_EQ(surface(root).numbers("primvars:crack_distance_1").size(), 12u);
}

TEST(Usda, FarFromTheOriginDigitsAreKept) {
  SurfaceMesh cube = make_shape("cube?n=8");
  const SurfaceMesh near = cube;
  const Vec3 far(431250.5, 5412375.25, 90);
  for (Vec3& p : cube.positions) p += far;
  const UsdPrim root = parse_usda(format_mesh(cube, "usda"));
  const auto place = surface(root).numbers("xformOp:translate");
  const auto points = surface(root).numbers("points");
  EXPECT_EQ(surface(root).types.at("xformOp:translate"), "double3");
  for (std::size_t v = 0; v < cube.positions.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      const float local = static_cast<float>(points[3 * v + k]);
      EXPECT_NEAR(place[k] + local, cube.positions[v][static_cast<Eigen::Index>(k)], 1e-6);
    }
  }
  const UsdPrim at_home = parse_usda(format_mesh(near, "usda"));
  EXPECT_FALSE(surface(at_home).values.count("xformOp:translate"));
}

TEST(Usda, ObjectsHaveAPlaceEachAndStillMeet) {
  SurfaceMesh mesh = rich();
  for (Vec3& p : mesh.positions) p = p / 3 + Vec3(0.1, 0.7, 11);
  MeshFileOptions options;
  options.objects = "fragment";
  const UsdPrim root = parse_usda(format_mesh(mesh, "usda", options));
  ASSERT_EQ(root.at("craze").children.size(), 3u);
  const auto corner = [&](const char* name, std::size_t v) {
    const UsdPrim& prim = root.at("craze").at(name);
    const auto place = prim.numbers("xformOp:translate"), points = prim.numbers("points");
    Vec3 p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[static_cast<Eigen::Index>(k)] = place[k] + static_cast<float>(points[3 * v + k]);
    }
    return p;
  };
  EXPECT_EQ(corner("fragment_7", 0), corner("fragment_8", 0));
  EXPECT_EQ(corner("fragment_7", 2), corner("fragment_8", 1));
  EXPECT_LT((corner("fragment_7", 1) - mesh.positions[1]).norm(), 1e-5);
}

TEST(Usda, AnAnimationIsTimeSamplesThatEndAtThePoints) {
  MorphAnimation animation;
  animation.seconds = 2;
  animation.stages = {{{1, 2}, {Vec3(0.5, 0, 0), Vec3(0, 0, 0.25)}}, {{1}, {Vec3(0, 0.5, 0)}}};
  MeshFileOptions options;
  options.animation = &animation;
  const UsdPrim root = parse_usda(format_mesh(rich(), "usda", options));
  EXPECT_EQ(root.metadata.at("timeCodesPerSecond"), "24");
  EXPECT_EQ(root.metadata.at("endTimeCode"), "78");
  // A key, then twelve numbers; three times.
  const auto samples = surface(root).numbers("points.timeSamples");
  ASSERT_EQ(samples.size(), 39u);
  EXPECT_EQ((std::vector<double>{samples[0], samples[13], samples[26]}),
            (std::vector<double>{6, 30, 54}));
  const auto vertex = [&](std::size_t key, std::size_t v) {
    const double* p = &samples[13 * key + 1 + 3 * v];
    return Vec3(p[0], p[1], p[2]);
  };
  EXPECT_EQ(vertex(0, 1), Vec3(0.5, -0.5, 0));
  EXPECT_EQ(vertex(1, 1), Vec3(1, -0.5, 0));
  EXPECT_EQ(vertex(2, 1), Vec3(1, 0, 0));
  EXPECT_EQ(vertex(0, 2), Vec3(1, 1, 0));
  const auto points = surface(root).numbers("points");
  EXPECT_TRUE(std::equal(points.begin(), points.end(), samples.begin() + 27));
  EXPECT_EQ(surface(root).numbers("extent")[1], -0.5) << "of the whole clip";
}

TEST(Usda, ACoordinateBeyondSinglePrecisionIsRefused) {
  SurfaceMesh mesh = rich();
  mesh.positions[0].x() = 1e300;
  message_of([&] { format_mesh(mesh, "usda"); }, ErrorKind::request);
}

TEST(Usda, GoesByItsExtensionAndIsNotRead) {
  MeshFileOptions options;
  options.up = UpAxis::z;
  options.metres_per_unit = 0.001;
  const std::string text = format_mesh(rich(), "usda", options);
  const UsdPrim root = parse_usda(text);
  EXPECT_EQ(root.metadata.at("upAxis"), "\"Z\"");
  EXPECT_EQ(root.metadata.at("metersPerUnit"), "0.001");
  message_of([&] { read_mesh(text, "a.usda"); }, ErrorKind::input);
}

}  // namespace
}  // namespace craze
