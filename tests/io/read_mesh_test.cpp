#include "craze/read_mesh.h"

#include "craze/io/files/atomic_file.h"
#include "craze/write_mesh.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

TEST(ReadMesh, EveryFormatWrittenIsRead) {
  const TemporaryFolder folder;
  const SurfaceMesh mesh = rich_mesh();
  for (const char* name : {"a.ply", "a.obj", "a.stl", "a.glb", "b.PLY", "b.Obj"}) {
    write_mesh(folder / name, mesh);
    EXPECT_EQ(read_mesh_file(folder / name).mesh.triangles.size(), mesh.triangles.size()) << name;
  }
}

TEST(ReadMesh, TellingFirstBytesWinOverTheExtension) {
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.glb"}) {
    write_mesh(folder / name, rich_mesh());
    std::filesystem::rename(folder / name, folder / "a.obj");
    EXPECT_EQ(read_mesh_file(folder / "a.obj").mesh.triangles.size(), 8u) << name;
  }
}

TEST(ReadMesh, TheModelsOwnFolderHoldsItsBuffers) {
  const TemporaryFolder folder;
  write_file(folder / "t.bin", std::string(36, '\0'));
  write_file(
      folder / "t.gltf",
      R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"t.bin"}]})");
  EXPECT_EQ(read_mesh_file(folder / "t.gltf").mesh.triangles.size(), 1u);
}

TEST(ReadMesh, UnknownExtensionsAndEmptyFilesAreSaidToBeSo) {
  const TemporaryFolder folder;
  write_file(folder / "a.fbx", "x");
  write_file(folder / "a.obj", "");
  EXPECT_NE(message_of([&] { read_mesh_file(folder / "a.fbx"); }).find("'.fbx'"),
            std::string::npos);
  EXPECT_NE(message_of([&] { read_mesh_file(folder / "a.obj"); }).find("empty"), std::string::npos);
  message_of([&] { write_mesh(folder / "a.fbx", rich_mesh()); }, ErrorKind::usage);
}

}  // namespace
}  // namespace craze
