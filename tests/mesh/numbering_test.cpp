#include "craze/mesh/numbering/spatial_numbering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "craze/shapes.h"
#include "mesh/shuffled.h"

namespace craze {
namespace {

/// A surface that has everything, each number another one.
SurfaceMesh with_everything(SurfaceMesh mesh) {
  const auto vertices = static_cast<int>(mesh.positions.size());
  const auto faces = static_cast<int>(mesh.triangles.size());
  for (int c = 0; c < 3 * faces; ++c) {
    mesh.corner_uvs.emplace_back(c, -c);
    mesh.corner_normals.emplace_back(c, 1, 2);
  }
  Attribute weight{"weight", 2, {}}, layer{"layer", 1, {}};
  for (int v = 0; v < vertices; ++v) {
    mesh.vertex_colors.push_back({static_cast<float>(v), 0, 0, 1});
    weight.values.insert(weight.values.end(), {v + 0.25, v + 0.5});
  }
  for (int f = 0; f < faces; ++f) {
    mesh.face_materials.push_back(f % 3);
    mesh.face_objects.push_back(f % 2);
    mesh.source_faces.push_back(2 * f);
    layer.values.push_back(f);
  }
  mesh.vertex_attributes.push_back(weight);
  mesh.face_attributes.push_back(layer);
  return mesh;
}

/// Of face f of a surface that has everything, all that it holds.
std::vector<double> contents(const SurfaceMesh& mesh, std::size_t f) {
  std::vector<double> all = {double(mesh.face_materials[f]), double(mesh.face_objects[f]),
                             double(mesh.source_faces[f]), mesh.face_attributes[0].values[f]};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto v = static_cast<std::size_t>(mesh.triangles[f][i]);
    const Vec3& p = mesh.positions[v];
    all.insert(all.end(), {p[0], p[1], p[2], mesh.vertex_colors[v][0]});
    all.insert(all.end(), {mesh.vertex_attributes[0].values[2 * v],
                           mesh.vertex_attributes[0].values[2 * v + 1]});
    all.insert(all.end(), {mesh.corner_uvs[3 * f + i][0], mesh.corner_normals[3 * f + i][0]});
  }
  return all;
}

TEST(Numbering, EverythingGoesWithItsFaceAndComesBack) {
  const SurfaceMesh before = with_everything(make_shape("torus?n=12"));
  const Numbering numbering = spatial_numbering(before.positions, before.triangles);
  SurfaceMesh mesh = before;
  renumber(mesh, numbering);
  ASSERT_NE(mesh.triangles, before.triangles);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    ASSERT_EQ(contents(mesh, f), contents(before, static_cast<std::size_t>(numbering.faces[f])));
  }
  renumber(mesh, inverse(numbering));
  EXPECT_EQ(mesh.positions, before.positions);
  EXPECT_EQ(mesh.triangles, before.triangles);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    ASSERT_EQ(contents(mesh, f), contents(before, f));
  }
}

TEST(Numbering, FollowsFromPositionsWhateverTheNumbersWere) {
  for (const char* shape : {"plate?n=20", "plate?n=20&jitter=0.3", "sphere?n=6", "torus?n=30"}) {
    SurfaceMesh mesh = make_shape(shape), shuffled = test::shuffled(mesh, 5);
    ASSERT_NE(mesh.positions, shuffled.positions);
    for (SurfaceMesh* m : {&mesh, &shuffled})
      renumber(*m, spatial_numbering(m->positions, m->triangles));
    EXPECT_EQ(mesh.positions, shuffled.positions) << shape;
    EXPECT_EQ(mesh.triangles, shuffled.triangles) << shape;
  }
}

/// Mean distance of the numbers of two neighbours.
double mean_jump(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) sum += std::abs(t[i] - t[(i + 1) % 3]);
  }
  return sum / (3 * static_cast<double>(mesh.triangles.size()));
}

TEST(Numbering, NeighboursAreNearInMemory) {
  const SurfaceMesh mesh = make_shape("sphere?n=60");
  SurfaceMesh ordered = test::shuffled(mesh, 1);
  const double scattered = mean_jump(ordered);
  renumber(ordered, spatial_numbering(ordered.positions, ordered.triangles));
  EXPECT_LT(mean_jump(ordered), 0.05 * scattered);
  // Half of all neighbours, whatever the size, within a few lines of a cache.
  std::vector<int> jumps;
  for (const Triangle& t : ordered.triangles) {
    for (int i = 0; i < 3; ++i) jumps.push_back(std::abs(t[i] - t[(i + 1) % 3]));
  }
  std::nth_element(jumps.begin(), jumps.begin() + static_cast<int>(jumps.size() / 2), jumps.end());
  EXPECT_LT(jumps[jumps.size() / 2], 16);
}

TEST(Numbering, VerticesAtOnePlaceAndMeshesWithoutExtent) {
  const std::vector<Vec3> positions = {{1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Numbering both = spatial_numbering(positions, {{1, 0, 3}, {3, 2, 1}});
  std::vector<std::int32_t> sorted = both.vertices;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_EQ(both.faces.size(), 2U);
  EXPECT_EQ(spatial_numbering({{2, 2, 2}, {2, 2, 2}}, {}).vertices,
            (std::vector<std::int32_t>{0, 1}));
  EXPECT_TRUE(spatial_numbering({}, {}).empty());
}

}  // namespace
}  // namespace craze
