// What we write must mean the same to another reader: Assimp, which keeps single precision.
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "craze/io/write_mesh.h"
#include "io_test_tools.h"

namespace craze {
namespace {

/// The corners of all faces, whatever the meshes they were put into.
struct Soup {
  std::vector<Vec3> positions, normals;
  std::vector<Vec2> uvs;
  std::vector<std::string> materials;
};

Soup read_with_assimp(const std::filesystem::path& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  EXPECT_NE(scene, nullptr) << importer.GetErrorString();
  Soup soup;
  for (unsigned m = 0; scene != nullptr && m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      EXPECT_EQ(mesh.mFaces[f].mNumIndices, 3u);
      soup.materials.emplace_back(scene->mMaterials[mesh.mMaterialIndex]->GetName().C_Str());
      for (unsigned i = 0; i < 3; ++i) {
        const unsigned v = mesh.mFaces[f].mIndices[i];
        const aiVector3D& p = mesh.mVertices[v];
        soup.positions.emplace_back(p.x, p.y, p.z);
        if (mesh.HasNormals()) {
          const aiVector3D& n = mesh.mNormals[v];
          soup.normals.emplace_back(n.x, n.y, n.z);
        }
        if (mesh.HasTextureCoords(0)) {
          soup.uvs.emplace_back(mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y);
        }
      }
    }
  }
  return soup;
}

/// One material's faces after another's, as formats with groups have them.
SurfaceMesh grouped_mesh() {
  SurfaceMesh mesh = rich_mesh(4);
  mesh.face_materials = {0, 0, 0, 0, 1, 1, 1, 1};
  return mesh;
}

class IndependentReader : public testing::TestWithParam<const char*> {};

TEST_P(IndependentReader, SeesTheSameCornersAndMaterials) {
  const std::string extension = GetParam();
  const TemporaryFolder folder;
  const SurfaceMesh mesh = grouped_mesh();
  write_mesh(folder / ("a" + extension), mesh);
  const Soup soup = read_with_assimp(folder / ("a" + extension));
  ASSERT_EQ(soup.positions.size(), 3 * mesh.triangles.size());
  for (std::size_t c = 0; c < soup.positions.size(); ++c) {
    const Vec3& p = mesh.positions[mesh.triangles[c / 3][c % 3]];
    EXPECT_LE((soup.positions[c] - p).norm(), 1e-6) << "corner " << c;
  }
  ASSERT_EQ(soup.normals.size(), soup.positions.size());
  for (std::size_t c = 0; c < soup.normals.size(); ++c) {
    EXPECT_LE((soup.normals[c] - mesh.corner_normals[c]).norm(), 1e-6);
  }
  if (extension == ".stl") return;
  ASSERT_EQ(soup.uvs.size(), soup.positions.size());
  for (std::size_t c = 0; c < soup.uvs.size(); ++c) {
    EXPECT_LE((soup.uvs[c] - mesh.corner_uvs[c]).norm(), 1e-6);
  }
  if (extension == ".ply") return;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    EXPECT_EQ(soup.materials[f], mesh.material_names[mesh.face_materials[f]]);
  }
}

INSTANTIATE_TEST_SUITE_P(Io, IndependentReader, testing::Values(".ply", ".obj", ".stl", ".glb"),
                         [](const auto& instance) { return std::string(instance.param + 1); });

}  // namespace
}  // namespace craze
