// What we write must mean the same to another reader: Assimp, which keeps single precision.
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include <algorithm>

#include "craze/job/run.h"
#include "craze/presets.h"
#include "craze/read_mesh.h"
#include "craze/write_mesh.h"
#include "io/io_test_tools.h"

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

/// A run on a mesh with two materials, UVs with a seam, smooth normals and colours.
SurfaceMesh crack_and_write(const TemporaryFolder& folder, const std::filesystem::path& output) {
  SurfaceMesh input;
  input.material_names = {"left", "right"};
  constexpr int n = 12;
  const auto place = [](int i, int j) {
    const double x = i / double(n), y = j / double(n);
    return Vec3(x, y, 0.2 * std::sin(3 * x));
  };
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      input.positions.push_back(place(i, j));
      input.vertex_colors.push_back({float(i) / n, float(j) / n, 0.5f, 1});
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + n + 1;
      for (const Triangle& t : {Triangle{a, a + 1, b + 1}, Triangle{a, b + 1, b}}) {
        input.triangles.push_back(t);
        input.face_materials.push_back(i < n / 2 ? 0 : 1);
        for (const std::int32_t v : t) {
          const Vec3& p = input.positions[v];
          input.corner_uvs.emplace_back(p.x() / 2 + (i < n / 2 ? 0 : 0.4), p.y());
          input.corner_normals.push_back(Vec3(-0.6 * std::cos(3 * p.x()), 0, 1).normalized());
        }
      }
    }
  }
  write_mesh(folder / "input.ply", input);
  RunRequest request;
  request.input = folder / "input.ply";
  request.output = output;
  request.recipe = read_preset("mud");
  apply_set(request.recipe, "layer.relative_spacing=0.2");
  apply_set(request.recipe, "post.gap=0.05");
  apply_set(request.recipe, "post.wall=0.02");
  run(request, {});
  return input;
}

TEST_P(IndependentReader, SeesWhatCrackingKeptOfTheInput) {
  const std::string extension = GetParam();
  const TemporaryFolder folder;
  crack_and_write(folder, folder / "exact.ply");
  crack_and_write(folder, folder / ("a" + extension));
  const SurfaceMesh exact = read_mesh_file(folder / "exact.ply").mesh;
  ASSERT_GT(exact.triangles.size(), 400u) << "it cracked";
  const Soup soup = read_with_assimp(folder / ("a" + extension));
  ASSERT_EQ(soup.positions.size(), 3 * exact.triangles.size());

  const auto distance = [&](std::size_t f, std::size_t g) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += (soup.positions[3 * g + i] - exact.positions[exact.triangles[f][i]]).norm();
    }
    return sum;
  };
  for (std::size_t f = 0; f < exact.triangles.size(); ++f) {
    // Formats order faces by material; a face is known by its corners.
    std::size_t g = 0;
    for (std::size_t other = 1; other < exact.triangles.size(); ++other) {
      if (distance(f, other) < distance(f, g)) g = other;
    }
    EXPECT_LE(distance(f, g), 1e-6) << "face " << f << " is lost";
    for (std::size_t i = 0; i < 3; ++i) {
      if (extension == ".stl") continue;
      EXPECT_LE((soup.normals[3 * g + i] - exact.corner_normals[3 * f + i]).norm(), 1e-6);
      EXPECT_LE((soup.uvs[3 * g + i] - exact.corner_uvs[3 * f + i]).norm(), 1e-6);
    }
    if (extension == ".obj" || extension == ".glb") {
      EXPECT_EQ(soup.materials[g], exact.material_names[exact.face_materials[f]]);
    }
  }
}

TEST(CrackedMesh, AttributesOfTheCracksComeThrough) {
  const TemporaryFolder folder;
  const SurfaceMesh input = crack_and_write(folder, folder / "a.ply");
  crack_and_write(folder, folder / "a.glb");
  for (const char* extension : {".ply", ".glb"}) {
    const SurfaceMesh mesh = read_mesh_file(folder / (std::string("a") + extension)).mesh;
    const Attribute* distance = find_attribute(mesh.vertex_attributes, "crack_distance");
    ASSERT_TRUE(distance) << extension;
    ASSERT_TRUE(find_attribute(mesh.vertex_attributes, "crack_time")) << extension;
    EXPECT_GT(std::count(distance->values.begin(), distance->values.end(), 0.0), 50);
    // Colours are functions of the place; gaps move vertices by little.
    ASSERT_EQ(mesh.vertex_colors.size(), mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      EXPECT_NEAR(mesh.vertex_colors[v][0], mesh.positions[v].x(), 0.03);
      EXPECT_NEAR(mesh.vertex_colors[v][1], mesh.positions[v].y(), 0.03);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Io, IndependentReader, testing::Values(".ply", ".obj", ".stl", ".glb"),
                         [](const auto& instance) { return std::string(instance.param + 1); });

}  // namespace
}  // namespace craze
