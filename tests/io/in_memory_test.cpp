// Meshes, lines and pictures without files; what every format owes to text, warnings and a cancel.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <thread>

#include "craze/io/lines/read_lines.h"
#include "craze/io/lines/write_lines.h"
#include "craze/io/mesh_formats.h"
#include "craze/read_mesh.h"
#include "craze/shapes.h"
#include "craze/write_mesh.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

const std::string obj_of_a_triangle = "v 0 0 0\nv 2 0 0\nv 2 2 0\nf 1 2 3\n";

TEST(InMemory, EveryFormatThatIsWrittenAndReadIsReadWhateverItsName) {
  for (const MeshFormat& format : mesh_formats()) {
    if (!format.write || !format.read) continue;
    const std::string bytes = format_mesh(rich_mesh(), format.name);
    const std::string name = "a." + std::string(format.name);
    EXPECT_EQ(read_mesh(bytes, name).mesh.triangles.size(), 8u) << name;
    if (!format.recognises) continue;
    EXPECT_EQ(read_mesh(bytes, "no extension").mesh.triangles.size(), 8u) << name;
  }
  message_of([] { format_mesh(rich_mesh(), "off"); }, ErrorKind::usage);
  message_of([] { format_mesh(rich_mesh(), "stl", {.objects = "fragment"}); }, ErrorKind::usage);
}

TEST(InMemory, FilesThatAMeshNamesComeFromItsCaller) {
  const std::string gltf =
      R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"t.bin"}]})";
  const FileLoader files = load_from_memory({{"t.bin", std::string(36, '\0')}});
  EXPECT_EQ(read_mesh(gltf, "a.gltf", files).mesh.triangles.size(), 1u);
  message_of([&] { read_mesh(gltf, "a.gltf"); });
  message_of([&] { read_mesh(gltf, "a.gltf", load_from_memory({})); });
}

std::string utf16(const std::string& text, bool big) {
  std::string bytes = big ? "\xfe\xff" : "\xff\xfe";
  for (const char c : text) {
    bytes += big ? std::string{'\0', c} : std::string{c, '\0'};
  }
  return bytes;
}

TEST(TextEncoding, MarksOfUtf8AndUtf16ChangeNothing) {
  const std::vector<std::pair<std::string, std::string>> texts = {
      {"a.obj", obj_of_a_triangle},
      {"a.off", "OFF\n3 1 0\n0 0 0\n2 0 0\n2 2 0\n3 0 1 2\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
       "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
       "0 0 0\n2 0 0\n2 2 0\n3 0 1 2\n"},
      {"a.stl",
       "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 2 2 0\nendloop\n"
       "endfacet\nendsolid\n"}};
  for (const auto& [name, text] : texts) {
    for (const std::string& bytes :
         {text, "\xef\xbb\xbf" + text, utf16(text, false), utf16(text, true)}) {
      EXPECT_EQ(read_mesh(bytes, name).mesh.positions,
                (std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}))
          << name;
    }
  }
  const auto lines =
      read_lines("\xef\xbb\xbf{\"points\":[[0,0],[1,0]],\"edges\":[[0,1]]}", "a.json");
  EXPECT_EQ(lines->edges.size(), 1u);
}

TEST(TextEncoding, NamesInUtf16BecomeUtf8) {
  const std::string bytes = utf16("usemtl ", false) + std::string("\xac\x20", 2) +
                            utf16("\n" + obj_of_a_triangle, false).substr(2);
  EXPECT_EQ(read_mesh(bytes, "a.obj").mesh.material_names,
            (std::vector<std::string>{"\xe2\x82\xac"}));
}

TEST(TextEncoding, Utf32IsRefusedByName) {
  const std::string bytes("\xff\xfe\0\0v\0\0\0", 8);
  EXPECT_NE(message_of([&] { read_mesh(bytes, "a.obj"); }).find("UTF-32"), std::string::npos);
}

TEST(InMemory, LinesAreFormattedAndReadBack) {
  LineSet lines;
  lines.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  lines.edges = {{0, 1}, {1, 2}};
  for (const char* format : {"ply", "obj", "json"}) {
    const auto back = read_lines(format_lines(lines, format), std::string("a.") + format);
    ASSERT_TRUE(back) << format;
    EXPECT_EQ(back->points, lines.points) << format;
    EXPECT_EQ(back->edges, lines.edges) << format;
  }
  message_of([&] { format_lines(lines, "stl"); }, ErrorKind::usage);
}

TEST(Cancel, IsHeardByEveryReaderAndWriter) {
  const SurfaceMesh mesh = make_shape("plate?n=40");
  Context context;
  context.cancelled = [] { return true; };
  for (const char* format : {"ply", "obj", "stl", "glb"}) {
    EXPECT_THROW(format_mesh(mesh, format, {}, context), Cancelled) << format;
    const std::string bytes = format_mesh(mesh, format);
    EXPECT_THROW(read_mesh(bytes, std::string("a.") + format, {}, context), Cancelled) << format;
  }
  EXPECT_THROW(read_mesh("OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2", "a.off", {}, context), Cancelled);
}

TEST(ByteSink, GetsTheBytesOfAFileInPartsAndNoneIsLarge) {
  const SurfaceMesh mesh = rich_mesh(8000);
  for (const MeshFormat& format : mesh_formats()) {
    if (!format.write) continue;
    const std::string whole = format_mesh(mesh, format.name);
    std::string joined;
    std::size_t largest = 0;
    ByteSink sink([&](std::string_view part) {
      largest = std::max(largest, part.size());
      joined += part;
    });
    format.write(mesh, {}, sink, {});
    sink.flush();
    EXPECT_TRUE(joined == whole) << format.name;
    EXPECT_GT(whole.size(), std::size_t{1} << 19) << format.name;
    // GLB gives one array after the other.
    EXPECT_LT(largest, format.name == "glb" ? whole.size() / 3 : (std::size_t{1} << 18) + 1000)
        << format.name;
  }
}

TEST(WriteMesh, LeavesWhatWasThereWhereTheMeshCannotBeHeldToItsEnd) {
  const TemporaryFolder folder;
  const auto file = folder / "a.stl";
  write_mesh(file, rich_mesh());
  const std::string before = read_text(file);
  SurfaceMesh mesh = rich_mesh(20000);
  mesh.positions.back().x() = 1e60;  // more than STL can hold, far into the file
  message_of([&] { write_mesh(file, mesh); }, ErrorKind::request);
  EXPECT_TRUE(read_text(file) == before);
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(WriteMesh, GivesPipesAllOrNothing) {
  const TemporaryFolder folder;
  const std::string name = (folder / "pipe.stl").string();
  ASSERT_EQ(::mkfifo(name.c_str(), 0600), 0);
  SurfaceMesh mesh = rich_mesh(20000);
  const double x = mesh.positions.back().x();
  mesh.positions.back().x() = 1e60;
  // Nobody reads: a write would wait for ever.
  message_of([&] { write_mesh(name, mesh); }, ErrorKind::request);
  mesh.positions.back().x() = x;
  std::string got;
  std::thread reader([&] { got = read_text(name); });
  write_mesh(name, mesh);
  reader.join();
  EXPECT_TRUE(got == format_mesh(mesh, "stl"));
}

TEST(Progress, OfReadersAndWritersGoesFromZeroToOne) {
  const SurfaceMesh mesh = make_shape("plate?n=150");
  std::vector<double> fractions;
  std::string phase;
  Context context;
  context.progress = [&](const Progress& p) {
    phase = p.phase;
    fractions.push_back(p.fraction);
  };
  for (const char* format : {"ply", "obj", "stl"}) {
    const std::string name = std::string("a.") + format;
    fractions.clear();
    const std::string bytes = format_mesh(mesh, format, {}, context);
    EXPECT_EQ(phase, "write") << name;
    EXPECT_GT(fractions.size(), 1u) << name;
    read_mesh(bytes, name, {}, context);
    EXPECT_EQ(phase, "load") << name;
    for (const double f : fractions) EXPECT_TRUE(f >= 0 && f <= 1) << name;
  }
}

TEST(Precision, LostToStlIsMeasuredAndOnlyWhereItMatters) {
  std::vector<std::string> said;
  const MeshFileOptions options{.warn = [&](const std::string& s) { said.push_back(s); }};
  SurfaceMesh mesh = rich_mesh();
  format_mesh(mesh, "stl", options);
  EXPECT_TRUE(said.empty());
  for (Vec3& p : mesh.positions) p += Vec3(431250, 5412375, 0);
  format_mesh(mesh, "stl", options);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("of 8 triangles lose their area"), std::string::npos) << said[0];
}

}  // namespace
}  // namespace craze
