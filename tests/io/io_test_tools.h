// Meshes and error messages for the tests of io.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "craze/error.h"
#include "craze/io/mesh_source.h"
#include "craze/read_mesh.h"
#include "craze/surface_mesh.h"
#include "error_message.h"
#include "temporary_folder.h"

namespace craze {

/// As error_of(), of wrong files where nothing else is said.
template <class Run>
std::string message_of(Run run, ErrorKind kind = ErrorKind::input) {
  return error_of(run, kind);
}

inline std::string read_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// A file's bytes through one reader, whatever its name.
inline MeshFile read_by(SurfaceMesh (*reader)(const MeshSource&), std::string_view bytes,
                        const std::string& name = "a.file", const FileLoader& files = {}) {
  MeshFile file;
  file.mesh = reader({bytes, name, files, Context{}, file.warnings, file.textures, file.scene});
  return file;
}

/// A bent strip of 2 n triangles over n squares whose numbers have no short decimal form. UVs have
/// a seam in the middle, normals are per face, two materials, colours and attributes.
inline SurfaceMesh rich_mesh(int n = 4) {
  SurfaceMesh mesh;
  mesh.material_names = {"red clay", "glaze"};
  Attribute time{"crack_time", 1, {}}, move{"displacement", 3, {}};
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < 2; ++j) {
      const double x = i / 3.0, y = j / 7.0;
      mesh.positions.emplace_back(x, y, std::sin(x));
      mesh.vertex_colors.push_back({static_cast<float>(i) / 255, 0.2f, 1, 1});
      time.values.push_back(x * x / 11);
      for (const double d : {x / 3, y / 3, -1.0 / 3}) move.values.push_back(d);
    }
  }
  mesh.vertex_attributes = {time, move};
  Attribute fragment{"fragment", 1, {}};
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i;
    const Vec3 normal = (mesh.positions[a + 2] - mesh.positions[a])
                            .cross(mesh.positions[a + 1] - mesh.positions[a])
                            .normalized();
    for (const Triangle& t : {Triangle{a, a + 2, a + 3}, Triangle{a, a + 3, a + 1}}) {
      mesh.triangles.push_back(t);
      mesh.face_materials.push_back(i % 2);
      mesh.source_faces.push_back(static_cast<std::int32_t>(mesh.source_faces.size()));
      fragment.values.push_back(i / 3.0);
      for (const std::int32_t v : t) {
        const double shift = i < n / 2 ? 0 : 0.25;  // the seam
        mesh.corner_uvs.emplace_back(mesh.positions[v].x() / 8 + shift, mesh.positions[v].y());
        mesh.corner_normals.push_back(normal);
      }
    }
  }
  mesh.face_attributes = {fragment};
  return mesh;
}

/// Compares what lies at the corners of the faces, whatever vertices they share.
inline void expect_same_corners(const SurfaceMesh& a, const SurfaceMesh& b, double tolerance) {
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  ASSERT_EQ(a.corner_uvs.size(), b.corner_uvs.size());
  ASSERT_EQ(a.corner_normals.size(), b.corner_normals.size());
  for (std::size_t c = 0; c < 3 * a.triangles.size(); ++c) {
    const Vec3& p = a.positions[a.triangles[c / 3][c % 3]];
    const Vec3& q = b.positions[b.triangles[c / 3][c % 3]];
    EXPECT_LE((p - q).norm(), tolerance) << "corner " << c;
    if (!a.corner_uvs.empty()) {
      EXPECT_LE((a.corner_uvs[c] - b.corner_uvs[c]).norm(), tolerance) << "corner " << c;
    }
    if (!a.corner_normals.empty()) {
      // Readers make normals unit again, which may move the last bit.
      EXPECT_LE((a.corner_normals[c] - b.corner_normals[c]).norm(), tolerance + 1e-15);
    }
  }
}

/// Compares a vertex attribute or the colours at the corners.
inline void expect_same_at_corners(const SurfaceMesh& a, const SurfaceMesh& b,
                                   const std::string& name, double tolerance) {
  const Attribute *x = find_attribute(a.vertex_attributes, name),
                  *y = find_attribute(b.vertex_attributes, name);
  ASSERT_NE(x, nullptr);
  ASSERT_NE(y, nullptr) << name << " is lost";
  ASSERT_EQ(x->components, y->components);
  for (std::size_t c = 0; c < 3 * a.triangles.size(); ++c) {
    for (int k = 0; k < x->components; ++k) {
      EXPECT_NEAR(x->values[x->components * a.triangles[c / 3][c % 3] + k],
                  y->values[x->components * b.triangles[c / 3][c % 3] + k], tolerance);
    }
  }
}

inline void expect_same_materials(const SurfaceMesh& a, const SurfaceMesh& b) {
  ASSERT_EQ(a.face_materials.size(), b.face_materials.size());
  for (std::size_t f = 0; f < a.face_materials.size(); ++f) {
    EXPECT_EQ(a.material_names[a.face_materials[f]], b.material_names[b.face_materials[f]]);
  }
}

}  // namespace craze
