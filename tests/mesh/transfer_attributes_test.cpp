#include "craze/mesh/transfer_attributes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "craze/base/random.h"
#include "craze/mesh/components.h"

namespace craze {
namespace {

/// A bent strip of quads with every attribute; UVs have a seam between columns 1 and 2.
SurfaceMesh strip(int columns) {
  SurfaceMesh mesh;
  for (int i = 0; i <= columns; ++i) {
    const double x = i, z = 0.1 * i * i;
    mesh.positions.emplace_back(x, 0, z);
    mesh.positions.emplace_back(x, 1.3, z);
  }
  Attribute height{"height", 1, {}}, pair{"pair", 2, {}}, face_number{"number", 1, {}};
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    height.values.push_back(mesh.positions[v].z());
    pair.values.push_back(0.1 * static_cast<double>(v));
    pair.values.push_back(-3);
    mesh.vertex_colors.push_back({0.1f * static_cast<float>(v % 7), 0.5f, 0.25f, 1});
  }
  for (std::int32_t i = 0; i < columns; ++i) {
    const std::int32_t a = 2 * i;
    mesh.triangles.push_back({a, a + 2, a + 1});
    mesh.triangles.push_back({a + 1, a + 2, a + 3});
  }
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    face_number.values.push_back(static_cast<double>(f) + 0.5);
    mesh.face_materials.push_back(static_cast<std::int32_t>(f % 2));
    mesh.face_objects.push_back(static_cast<std::int32_t>(f % 3) - 1);
    for (const std::int32_t v : mesh.triangles[f]) {
      const Vec3& p = mesh.positions[v];
      mesh.corner_uvs.emplace_back(p.x() / 3 + (f >= 4 ? 10 : 0), p.y() / 7);
      mesh.corner_normals.push_back(Vec3(-0.2 * p.x(), 0, 1).normalized());
    }
  }
  mesh.material_names = {"a", "b"};
  mesh.object_names = {"cup", "saucer"};
  mesh.vertex_attributes = {height, pair};
  mesh.face_attributes = {face_number};
  return mesh;
}

/// Splits and cuts edges at random.
TriangleMesh crack_at_random(const SurfaceMesh& surface, std::uint64_t seed, int edits) {
  TriangleMesh mesh(surface.positions, surface.triangles);
  Random random(seed);
  for (int i = 0; i < edits; ++i) {
    const auto h = static_cast<std::int32_t>(random.below(3 * mesh.face_count()));
    if (i % 3 != 2) {
      mesh.split_edge(h, random.uniform(0.1, 0.9));
    } else if (!mesh.is_open(h)) {
      mesh.cut(h, i);
    }
  }
  return mesh;
}

RC_GTEST_PROP(TransferAttributes, LinearAttributesStayLinearOnEachSourceTriangle,
              (std::uint64_t seed)) {
  const SurfaceMesh surface = strip(5);
  const TriangleMesh cut = crack_at_random(surface, seed, 60);
  const SurfaceMesh result = transfer_attributes(surface, cut);
  for (std::size_t k = 0; k < result.corner_uvs.size(); ++k) {
    const std::int32_t v = result.triangles[k / 3][k % 3];
    const Vec3& p = result.positions[v];
    const double shift = cut.source_face(static_cast<std::int32_t>(k / 3)) >= 4 ? 10 : 0;
    RC_ASSERT((result.corner_uvs[k] - Vec2(p.x() / 3 + shift, p.y() / 7)).norm() < 1e-12);
    RC_ASSERT(std::abs(result.corner_normals[k].norm() - 1) < 1e-12);
    RC_ASSERT(std::abs(result.vertex_attributes[0].values[v] - p.z()) < 1e-12);
    RC_ASSERT(std::abs(result.vertex_attributes[1].values[2 * v + 1] + 3) < 1e-12);
  }
}

RC_GTEST_PROP(TransferAttributes, CopiesAndNeighboursAgreeToTheLastBit, (std::uint64_t seed)) {
  const SurfaceMesh surface = strip(5);
  const TriangleMesh cut = crack_at_random(surface, seed, 60);
  const SurfaceMesh result = transfer_attributes(surface, cut);
  const Attribute& height = result.vertex_attributes[0];
  std::vector<Vec2> uv_of(2 * result.positions.size(), Vec2(-1, -1));
  for (std::size_t k = 0; k < result.corner_uvs.size(); ++k) {
    const auto h = static_cast<std::int32_t>(k);
    const std::int32_t root = cut.root(cut.from(h));
    const std::size_t side = cut.source_face(h / 3) >= 4 ? 1 : 0;
    Vec2& uv = uv_of[2 * root + side];
    if (uv.x() < 0) uv = result.corner_uvs[k];
    RC_ASSERT(uv == result.corner_uvs[k]);
    RC_ASSERT(height.values[cut.from(h)] == height.values[root]);
  }
}

RC_GTEST_PROP(TransferAttributes, TheInputsOwnVerticesKeepTheirExactValues, (std::uint64_t seed)) {
  const SurfaceMesh surface = strip(4);
  const TriangleMesh cut = crack_at_random(surface, seed, 40);
  const SurfaceMesh result = transfer_attributes(surface, cut);
  for (std::int32_t v = 0; v < cut.vertex_count(); ++v) {
    const std::int32_t root = cut.root(v);
    if (root >= static_cast<std::int32_t>(surface.positions.size())) continue;
    RC_ASSERT(result.vertex_attributes[0].values[v] == surface.vertex_attributes[0].values[root]);
    RC_ASSERT(result.vertex_colors[v] == surface.vertex_colors[root]);
  }
}

TEST(TransferAttributes, FacesKeepMaterialObjectNumberAndSource) {
  const SurfaceMesh surface = strip(3);
  const TriangleMesh cut = crack_at_random(surface, 4, 30);
  const SurfaceMesh result = transfer_attributes(surface, cut);
  for (std::int32_t f = 0; f < cut.face_count(); ++f) {
    const std::int32_t source = cut.source_face(f);
    EXPECT_EQ(result.source_faces[f], source);
    EXPECT_EQ(result.face_materials[f], surface.face_materials[source]);
    EXPECT_EQ(result.face_objects[f], surface.face_objects[source]);
    EXPECT_EQ(result.face_attributes[0].values[f], source + 0.5);
  }
  EXPECT_EQ(result.material_names, surface.material_names);
  EXPECT_EQ(result.object_names, surface.object_names);
}

TEST(TransferAttributes, WhatIsNotGivenStaysEmpty) {
  SurfaceMesh bare;
  bare.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
  bare.triangles = {{0, 1, 2}};
  bare.vertex_attributes = {{"a", 1, {1, 2, 3, 4}}};
  const SurfaceMesh result =
      transfer_attributes(bare, TriangleMesh(bare.positions, bare.triangles));
  EXPECT_TRUE(result.corner_uvs.empty() && result.corner_normals.empty());
  EXPECT_TRUE(result.vertex_colors.empty() && result.face_materials.empty());
  EXPECT_EQ(result.vertex_attributes[0].values[3], 4) << "a vertex without faces keeps its value";
}

TEST(LocateInTriangle, ATriangleWithoutAreaIsItsLongestEdge) {
  SurfaceMesh sliver;
  sliver.positions = {{0, 0, 0}, {1, 0, 0}, {4, 0, 0}};
  sliver.triangles = {{0, 1, 2}};
  const TrianglePoint at = locate_in_triangle(sliver, 0, {3, 0, 0});
  EXPECT_EQ(at.corners[0], 0);
  EXPECT_EQ(at.corners[1], 2);
  EXPECT_DOUBLE_EQ(at.weights[1], 0.75);
}

TEST(Components, ACutThroughTheStripMakesTwoParts) {
  const SurfaceMesh surface = strip(4);
  TriangleMesh mesh(surface.positions, surface.triangles);
  EXPECT_EQ(find_components(mesh).count, 1);
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.is_open(h)) continue;
    if (mesh.position(mesh.from(h)).x() == 2 && mesh.position(mesh.to(h)).x() == 2) mesh.cut(h, 0);
  }
  const Components parts = find_components(mesh);
  EXPECT_EQ(parts.count, 2);
  EXPECT_EQ(parts.face.front(), 0);
  EXPECT_EQ(parts.face.back(), 1);
}

}  // namespace
}  // namespace craze
