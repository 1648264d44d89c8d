// What of a surface may serve as a mask.
#include "craze/model/sources/mask_values.h"

#include <gtest/gtest.h>

#include "craze/error.h"
#include "craze/shapes.h"
#include "error_message.h"

namespace craze {
namespace {

using Place = Eigen::Matrix<double, 2, 3>;

/// A square of two triangles, of materials 0 and 1, with UVs and colours.
SurfaceMesh square() {
  SurfaceMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const Triangle& t : mesh.triangles) {
    for (const std::int32_t v : t) mesh.corner_uvs.push_back(mesh.positions[v].head<2>() / 2);
  }
  mesh.material_names = {"left", "right"};
  mesh.face_materials = {0, 1};
  mesh.vertex_colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 0.5f}};
  mesh.vertex_attributes = {{"heat", 1, {0, 1, 2, 3}}, {"worn", 1, {0, 0.5, 1 + 1e-9, -1e-9}}};
  return mesh;
}

TEST(MaskValues, NamesScalarsWithinTheirRange) {
  const std::vector<std::string> names{"worn", "color", "color_r", "color_g", "color_b", "color_a"};
  EXPECT_EQ(mask_names(square()), names);
  EXPECT_TRUE(mask_names(make_shape("plate?n=2")).empty());
}

TEST(MaskValues, AreThoseOfTheAttribute) {
  EXPECT_EQ(mask_at_vertices(square(), "worn"), (std::vector<double>{0, 0.5, 1, 0}));
  EXPECT_EQ(mask_at_vertices(square(), "color_b"), (std::vector<double>{0, 0, 1, 1}));
  EXPECT_NE(error_of([] { mask_at_vertices(square(), "heat"); }, ErrorKind::request).find("2.0"),
            std::string::npos);
  EXPECT_NE(error_of([] { mask_at_vertices(square(), "none"); }, ErrorKind::request).find("none"),
            std::string::npos);
}

/// Four pixels: 0 at the lower left, 0.25 beside it, 0.5 and 1 above.
GreyImage picture() {
  return {2, 2, {0.5f, 1, 0, 0.25f}};
}

TEST(MaskValues, APictureSetsTheVerticesOfItsMaterial) {
  // UVs of the middles of pixels: 0 … 1/2 of the square and a quarter more.
  Place place = Place::Identity();
  place(0, 2) = place(1, 2) = 0.25;
  std::vector<double> values(4, -1);
  set_mask_from_picture(square(), 0, picture(), place, values.data());
  EXPECT_EQ(values, (std::vector<double>{0, 0.25, 1, -1}));
  set_mask_from_picture(square(), 1, picture(), place, values.data());
  EXPECT_EQ(values, (std::vector<double>{0, 0.25, 1, 0.5}));
  SurfaceMesh bare = square();
  bare.corner_uvs.clear();
  const auto set = [&] { set_mask_from_picture(bare, 0, picture(), place, values.data()); };
  EXPECT_NE(error_of(set, ErrorKind::request).find("UVs"), std::string::npos);
}

}  // namespace
}  // namespace craze
