// Maps of whole runs.
#include <gtest/gtest.h>

#include "craze/engine.h"
#include "craze/maps.h"
#include "craze/presets.h"
#include "craze/products.h"
#include "craze/shapes.h"

namespace craze {
namespace {

Result cracked(const char* shape, OutputMesh output) {
  Recipe recipe = read_preset("mud");
  recipe.mesh.output = output;
  recipe.simulation.layer.relative_spacing = 0.2;
  Input input;
  input.surface = std::make_shared<const SurfaceMesh>(make_shape(shape));
  return crack(std::move(input), recipe, {}, {});
}

/// Where `texel` lies in face f of the mesh by its UVs; weights below 0: outside.
Vec3 weights_in(const SurfaceMesh& mesh, std::size_t f, const Vec2& texel) {
  const Vec2& a = mesh.corner_uvs[3 * f];
  Mat2 sides;
  sides << mesh.corner_uvs[3 * f + 1] - a, mesh.corner_uvs[3 * f + 2] - a;
  if (sides.determinant() == 0) return {-1, -1, -1};
  const Vec2 w = sides.inverse() * (texel - a);
  return {1 - w.x() - w.y(), w.x(), w.y()};
}

TEST(MapsOfRuns, ShowEachPieceWhereTheCutMeshHasIt) {
  const int size = 128;
  for (const OutputMesh output : {OutputMesh::asset, OutputMesh::simulation}) {
    const Result result = cracked("cube", output);
    const SurfaceMesh cut = cut_mesh(result, {});
    const Attribute& fragment = *find_attribute(cut.face_attributes, "fragment");
    MapOptions options;
    options.size = size;
    options.maps = {MapKind::position, MapKind::fragment};
    std::vector<std::string> warnings;
    const std::vector<Map> maps = baked_maps(result, options, warnings, {});
    EXPECT_TRUE(warnings.empty());
    int seen = 0;
    for (std::size_t f = 0; f < cut.triangles.size(); ++f) {
      const Vec2 uv =
          (cut.corner_uvs[3 * f] + cut.corner_uvs[3 * f + 1] + cut.corner_uvs[3 * f + 2]) / 3;
      const int x = static_cast<int>(uv.x() * size), y = static_cast<int>((1 - uv.y()) * size);
      const Vec3 w = weights_in(cut, f, {(x + 0.5) / size, 1 - (y + 0.5) / size});
      if (w.minCoeff() < 1e-9) continue;
      ++seen;
      Vec3 place = Vec3::Zero();
      for (int i = 0; i < 3; ++i) place += w[i] * cut.positions[cut.triangles[f][i]];
      const std::size_t texel = static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x);
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(maps[0].values[3 * texel + static_cast<std::size_t>(c)], place[c], 1e-6);
      }
      ASSERT_EQ(maps[1].values[texel], 1 + fragment.values[f]);
    }
    EXPECT_GT(seen, 100);
  }
}

}  // namespace
}  // namespace craze
