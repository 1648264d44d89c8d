// Chips: how many there are and where, in maps and in meshes.
#include "craze/products/chips/chips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "craze/mesh/self_intersection.h"
#include "products/maps/height_and_normal.h"
#include "products/maps/plates.h"
#include "products/solids/solid_checks.h"

namespace craze {
namespace {

/// A crack of n pieces of length 1/4.
std::vector<MapCrack> straight(std::int32_t n) {
  std::vector<MapCrack> cracks;
  for (std::int32_t i = 0; i < n; ++i) {
    MapCrack crack = crack_from(i / 4.0, 0.5, (i + 1) / 4.0, 0.5, 0.2, 0.2);
    crack.number = i;
    crack.roots = {i, i + 1};
    cracks.push_back(crack);
  }
  return cracks;
}

std::vector<std::array<double, 2>> halves(std::size_t n, double half = 0.1) {
  return std::vector<std::array<double, 2>>(n, {half, half});
}

/// Share of the left rims of pieces in [from, to) that lies in chips.
double covered(const Chips& chips, int from, int to) {
  std::vector<std::array<double, 2>> spans;
  for (const Chip& chip : chips.chips) {
    const double at = chip.crack / 4.0 + chip.along;
    if (chip.left) spans.push_back({at - chip.reach, at + chip.reach});
  }
  std::sort(spans.begin(), spans.end());
  const double begin = from / 4.0, end = to / 4.0;
  double sum = 0, reached = begin;
  for (const auto& [low, high] : spans) {
    sum += std::max(0.0, std::min(high, end) - std::max(low, reached));
    reached = std::max(reached, std::min(high, end));
  }
  return sum / (end - begin);
}

ChipOptions options_with(double share, double size = 0.05) {
  ChipOptions options;
  options.share = share;
  options.size = size;
  options.spacing = 1;
  return options;
}

TEST(Chips, CoverTheShareOfTheRimsThatWasAskedFor) {
  for (const double share : {0.05, 0.3, 0.7}) {
    const Chips chips = place_chips(straight(2000), halves(2000), options_with(share));
    EXPECT_NEAR(covered(chips, 0, 2000), share, 0.03);
  }
  EXPECT_TRUE(place_chips(straight(4), halves(4), options_with(0)).chips.empty());
  EXPECT_TRUE(place_chips({}, {}, options_with(0.5)).chips.empty());
  EXPECT_GT(covered(place_chips(straight(2000), halves(2000), options_with(1)), 0, 2000), 0.95);
}

TEST(Chips, AreMoreAlongOldCracksAndAtJunctions) {
  std::vector<MapCrack> cracks = straight(4000);
  for (std::size_t i = 2000; i < 4000; ++i) cracks[i].time = 1;
  Chips chips = place_chips(cracks, halves(4000), options_with(0.3));
  EXPECT_GT(covered(chips, 0, 2000), 1.5 * covered(chips, 2000, 4000));
  // Every 20th root is a junction.
  std::vector<MapCrack> meeting = straight(4000);
  for (std::int32_t i = 0; i < 4000; i += 20) {
    MapCrack stub = crack_from(i / 4.0, 0.5, i / 4.0, 0.501, 0.2, 0.2);
    stub.roots = {i, 10000 + i};
    meeting.push_back(stub);
  }
  chips = place_chips(meeting, halves(meeting.size()), options_with(0.3));
  double near = 0, away = 0;
  for (const Chip& chip : chips.chips) {
    if (chip.crack >= 4000) continue;
    (chip.crack % 20 == 0 && chip.along < 0.1 ? near : away) += 1;
  }
  EXPECT_GT(near / 0.1, 1.2 * away / 4.9);
}

TEST(Chips, AreAsSmallAsTheCracksAndTheirDistanceAllow) {
  const auto chips_of = [](double half) {
    return place_chips(straight(400), halves(400, half), options_with(0.5, 1e9)).chips;
  };
  for (const Chip& chip : chips_of(0.001)) EXPECT_LE(chip.reach, 0.0121);
  for (const Chip& chip : chips_of(10)) {
    EXPECT_LE(chip.reach, 1.0 / 3 + 1e-12);
    EXPECT_LE(chip.depth, chip.reach / 2);
  }
  EXPECT_TRUE(chips_of(0).empty());
  // What would be too many becomes larger, and is said.
  const Chips many = place_chips(straight(2000), halves(2000), options_with(0.5, 1e-6));
  EXPECT_EQ(many.warnings.size(), 1U);
  EXPECT_LT(many.chips.size(), 36000U);
}

TEST(Chips, LieInsideTheirEllipseAndAreDeepestAtTheRim) {
  for (const Chip& chip : place_chips(straight(40), halves(40), options_with(0.5)).chips) {
    EXPECT_EQ(chip.depth_at({0, 0}), chip.depth);
    EXPECT_EQ(chip.depth_at({1.0001 * chip.reach, 0}), 0);
    EXPECT_EQ(chip.depth_at({0, 1.0001 * chip.inwards}), 0);
    const double in = chip.inwards_at(0);
    EXPECT_GT(in, 0.4 * chip.inwards);
    EXPECT_NEAR(chip.outline({0, in}), 1, 1e-4);
  }
}

PostParameters chipped_post(double share) {
  PostParameters post;
  post.gap = 0.06;
  post.wall = 0.02;
  post.chipping = share;
  return post;
}

TEST(Chips, AreInMapsWithNormalsThatFitTheHeights) {
  const Result result = test::cracked_shape("plate?n=30&jitter=0.3", "mud", 0.2);
  const int size = 256;
  MapOptions options =
      options_of(size, {MapKind::height, MapKind::normal, MapKind::mask, MapKind::width});
  std::vector<std::string> warnings;
  options.post = chipped_post(0);
  const std::vector<Map> whole = baked_maps(result, options, warnings, {});
  options.post = chipped_post(0.5);
  const std::vector<Map> chipped = baked_maps(result, options, warnings, {});
  EXPECT_LT(test::largest_tilt(chipped[0], chipped[1], size), 1);
  double more = 0;
  int wider = 0;
  for (std::size_t i = 0; i < whole[0].values.size(); ++i) {
    ASSERT_LE(chipped[0].values[i], whole[0].values[i] + 1e-7F);
    ASSERT_GE(chipped[2].values[i], whole[2].values[i] - 1e-6F);
    ASSERT_GE(chipped[3].values[i], whole[3].values[i] - 1e-6F);
    more += chipped[2].values[i] - whole[2].values[i];
    wider += chipped[3].values[i] > whole[3].values[i] + 1e-6F ? 1 : 0;
  }
  EXPECT_GT(more, 100);
  EXPECT_GT(wider, 1000);
  Context three;
  three.threads = 3;
  EXPECT_EQ(baked_maps(result, options, warnings, three)[0].values, chipped[0].values);
}

TEST(Chips, InMeshesNeitherCrossNorOpenThem) {
  for (const char* shape : {"plate?n=20&jitter=0.3", "cup", "sphere?n=14", "cube"}) {
    for (const OutputMesh output : {OutputMesh::asset, OutputMesh::simulation}) {
      SCOPED_TRACE(shape);
      const Result result = test::cracked_shape(shape, "mud", 0.2, output);
      for (const double share : {0.3, 1.0}) {
        PostParameters post = chipped_post(share);
        post.curl = share == 1 ? 0.5 : 0;
        const Opening opening(result, post, {});
        const SurfaceMesh mesh = opening.mesh();
        EXPECT_GT(mesh.triangles.size(), cut_mesh(result, {}).triangles.size());
        EXPECT_TRUE(self_intersections(mesh.positions, mesh.triangles).empty());
      }
    }
  }
}

TEST(Chips, OfSolidsLeaveThemClosedAndApart) {
  for (const char* shape : {"plate?n=20&jitter=0.3", "sphere?n=14", "cube"}) {
    SCOPED_TRACE(shape);
    const Result result = test::cracked_shape(shape, "mud", 0.2);
    for (const double gap : {0.0, 0.05}) {
      SCOPED_TRACE(gap);
      PostParameters post = chipped_post(0.4);
      post.thickness = 0.05;
      post.gap = gap;
      const Opening opening(result, post, {});
      const SurfaceMesh mesh = opening.mesh();
      for (const SurfaceMesh& solid : fragments(mesh)) {
        EXPECT_TRUE(test::is_closed(solid));
        EXPECT_GT(test::volume_of(solid), 0);
      }
      EXPECT_TRUE(self_intersections(mesh.positions, mesh.triangles).empty());
    }
  }
}

TEST(Chips, TakeLittleOfSolidsWhoseCellsAreSmall) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 11}) {
    Recipe recipe = read_preset("mud");
    recipe.simulation.layer.relative_spacing = 0.12;
    recipe.post.relative_roughness = 0;
    recipe.simulation.seed = seed;
    Input input;
    input.surface = std::make_shared<const SurfaceMesh>(make_shape("sphere?n=14"));
    const Result result = crack(std::move(input), recipe, {}, {});
    PostParameters post = chipped_post(0);
    post.gap = 0.05;
    post.thickness = 0.2;
    double volume[2] = {0, 0};
    for (const int chipped : {0, 1}) {
      post.chipping = 0.3 * chipped;
      const SurfaceMesh mesh = Opening(result, post, {}).mesh();
      for (const SurfaceMesh& s : fragments(mesh)) volume[chipped] += test::volume_of(s);
    }
    EXPECT_LT(volume[1], volume[0]);
    EXPECT_GT(volume[1], 0.995 * volume[0]) << seed;
  }
}

TEST(Chips, ComeWithTheGrowthOfTheirCracks) {
  const Result result = test::cracked_shape("plate?n=12", "mud", 0.25);
  const Opening opening(result, chipped_post(0.5), {});
  const GrowthClip clip(opening);
  const SurfaceMesh mesh = opening.mesh();
  for (const double time : {0.0, 0.5, 1.0}) {
    const std::vector<Vec3> at = clip.positions_at(time);
    ASSERT_EQ(at.size(), mesh.positions.size());
    double apart = 0, deepest = 0;
    for (std::size_t v = 0; v < at.size(); ++v) {
      ASSERT_TRUE(at[v].allFinite());
      apart = std::max(apart, (at[v] - mesh.positions[v]).norm());
      deepest = std::max(deepest, -at[v].z());
    }
    if (time == 1) {
      EXPECT_LT(apart, 1e-9);
    } else {
      EXPECT_GT(apart, 1e-3);
    }
    EXPECT_LE(deepest, 0.02 + 1e-9);  // the wall's
  }
}

TEST(Chips, OfShutCracksAreSaidToBeInMapsAlone) {
  const Result result = test::cracked_shape("plate?n=20&jitter=0.3", "mud", 0.2);
  PostParameters post;
  post.chipping = 0.5;
  for (const double thickness : {0.1, 0.0}) {
    post.thickness = thickness;
    const Opening solid(result, post, {});
    const auto& said = solid.warnings();
    EXPECT_EQ(std::count_if(said.begin(), said.end(),
                            [](const std::string& warning) {
                              return warning.find("post.chipping") != std::string::npos;
                            }),
              1)
        << thickness;
  }
  const Opening opening(result, post, {});
  EXPECT_EQ(opening.mesh().triangles.size(), cut_mesh(result, {}).triangles.size());
}

}  // namespace
}  // namespace craze
