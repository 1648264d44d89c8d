// What a format has no place for is named.
#include "craze/write_mesh.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

MeshFile commented_ply() {
  return read_mesh(
      "ply\nformat ascii 1.0\ncomment made by hand\ncomment TextureFile clay.png\n"
      "comment material glaze\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
      "a.ply");
}

std::vector<std::string> warnings_of(const MeshFile& file, const std::string& format) {
  std::vector<std::string> warnings;
  format_mesh(file.mesh, format, {.scene = file.scene, .warn = [&](const std::string& warning) {
                                    warnings.push_back(warning);
                                  }});
  return warnings;
}

TEST(LostContents, AreNamedInOneSentenceWhereTheFormatHasNoPlaceForThem) {
  const MeshFile file = commented_ply();
  for (const char* format : {"obj", "stl", "glb"}) {
    const auto warnings = warnings_of(file, format);
    ASSERT_EQ(warnings.size(), 1u) << format;
    EXPECT_NE(warnings[0].find("2 comments"), std::string::npos) << warnings[0];
  }
  EXPECT_TRUE(warnings_of(file, "ply").empty());
}

TEST(LostContents, CommentsOfPlyComeBackOnce) {
  const MeshFile file = commented_ply();
  std::string bytes = format_mesh(file.mesh, "ply", {.scene = file.scene});
  for (int round = 0; round < 2; ++round) {
    for (const char* comment : {"comment made by hand\n", "comment TextureFile clay.png\n"}) {
      const std::size_t at = bytes.find(comment);
      ASSERT_NE(at, std::string::npos);
      EXPECT_EQ(bytes.find(comment, at + 1), std::string::npos);
    }
    const MeshFile back = read_mesh(bytes, "a.ply");
    EXPECT_EQ(back.textures, (std::vector<std::string>{"clay.png"}));
    bytes = format_mesh(back.mesh, "ply", {.scene = back.scene});
  }
}

}  // namespace
}  // namespace craze
