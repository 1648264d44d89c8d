// [where]: cracks keep off what is forbidden, and masks fade them out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "craze/engine.h"
#include "craze/engine/check_where.h"
#include "craze/engine/spacing_rounds.h"
#include "craze/model/sources/crack_mask.h"
#include "craze/presets.h"
#include "craze/products.h"
#include "craze/shapes.h"
#include "error_message.h"
#include "recipe_with.h"

namespace craze {
namespace {

constexpr double border = -0.1;  // x of the line between two halves of a plate

double middle_x(const SurfaceMesh& mesh, const Triangle& t) {
  return (mesh.positions[t[0]].x() + mesh.positions[t[1]].x() + mesh.positions[t[2]].x()) / 3;
}

/// A plate in two halves: materials, objects, a face attribute and, fading over all of it, a vertex
/// attribute.
SurfaceMesh halves(const std::string& shape = "plate?n=20") {
  SurfaceMesh plate = make_shape(shape);
  plate.material_names = {"glass", "leather"};
  plate.object_names = {"door_left", "door_right"};
  Attribute half{"half", 1, {}}, fade{"fade", 1, {}};
  plate.face_materials.clear();
  for (const Triangle& t : plate.triangles) {
    const int right = middle_x(plate, t) > border ? 1 : 0;
    plate.face_materials.push_back(right);
    plate.face_objects.push_back(right);
    half.values.push_back(right);
  }
  for (const Vec3& p : plate.positions) fade.values.push_back(std::clamp(p.x() + 0.5, 0.0, 1.0));
  plate.face_attributes.push_back(half);
  plate.vertex_attributes.push_back(fade);
  return plate;
}

Recipe mud_recipe(const std::vector<std::string>& settings) {
  return recipe_with(settings, recipe_with({"layer.relative_spacing=0.12"}, read_preset("mud")));
}

LineSet lines_of(const SurfaceMesh& mesh, const Recipe& recipe) {
  return crack_lines(
      crack({std::make_shared<const SurfaceMesh>(mesh), {}, "plate"}, recipe, {}, {}));
}

void expect_cracks_right_of(double x, const LineSet& lines, const std::string& what) {
  EXPECT_GT(lines.edges.size(), 20u) << what;
  for (const Vec3& p : lines.points) EXPECT_GE(p.x(), x - 1e-9) << what;
}

TEST(Where, CracksStayOnTheMaterialsAndObjectsThatAreNamed) {
  for (const char* given : {"where.materials=leather", "where.materials=l*", "where.nodes=door_r*",
                            "where.attribute=half"}) {
    for (const char* edge : {"mesh.edge=keep", "mesh.edge=0.03"}) {
      expect_cracks_right_of(border, lines_of(halves(), mud_recipe({given, edge})),
                             std::string(given) + " " + edge);
    }
  }
}

TEST(Where, InvertedIsTheRestOfTheSurface) {
  const LineSet lines =
      lines_of(halves(), mud_recipe({"where.materials=glass", "where.invert=true"}));
  expect_cracks_right_of(border, lines, "inverted");
}

TEST(Where, OfEulerStepsHoldsToo) {
  Recipe recipe = mud_recipe({"where.materials=leather", "mesh.edge=0.04", "engine=euler",
                              "evolution.shrinkage=0.003", "evolution.relaxation_steps=10"});
  expect_cracks_right_of(border, lines_of(halves(), recipe), "euler");
}

TEST(Where, NamesThatFitNothingSayWhatThereIs) {
  const SurfaceMesh plate = halves();
  WhereParameters where;
  where.materials = {"lether"};
  const std::string message = error_of([&] { check_where(plate, where); });
  EXPECT_NE(message.find("did you mean leather?"), std::string::npos) << message;
  EXPECT_NE(message.find("glass, leather"), std::string::npos) << message;
  where.materials = {"leather", "wood"};
  EXPECT_EQ(check_where(plate, where).size(), 1u);
  where = {};
  where.nodes = {"roof"};
  EXPECT_NE(error_of([&] { check_where(plate, where); }).find("door_left, door_right"),
            std::string::npos);
  EXPECT_NE(error_of([&] { check_where(make_shape("plate?n=2"), where); }).find("has no nodes"),
            std::string::npos);
  where = {};
  where.attribute = "fad";
  EXPECT_NE(error_of([&] { check_where(plate, where); }).find("did you mean fade?"),
            std::string::npos);
}

std::vector<double> mask_of(const SurfaceMesh& mesh, const WhereParameters& where,
                            const GreyImage& picture = {}) {
  return crack_mask(mesh, TriangleMesh(mesh.positions, mesh.triangles), where, picture, false);
}

TEST(ACrackMask, IsTheProductOfAllThatIsGivenOrOneMinusIt) {
  const SurfaceMesh plate = halves();
  WhereParameters where;
  EXPECT_TRUE(mask_of(plate, where).empty());
  where.materials = {"leather"};
  where.attribute = "fade";
  const std::vector<double> mask = mask_of(plate, where);
  where.invert = true;
  const std::vector<double> rest = mask_of(plate, where);
  for (std::size_t f = 0; f < mask.size(); ++f) {
    const double x = middle_x(plate, plate.triangles[f]);
    const double expected = x > border ? x + 0.5 : 0;
    EXPECT_NEAR(mask[f], expected, 1e-12);
    if (x < 0.45) {
      EXPECT_NEAR(rest[f], 1 - expected, 1e-12);
    }
  }
}

TEST(ACrackMask, IsZeroAtFacesWithABlackPixelOrAPaintedZeroAtACorner) {
  const SurfaceMesh plate = halves();
  GreyImage picture{4, 1, {0, 0.5F, 0.5F, 1}};
  WhereParameters where;
  where.texture = "picture";
  std::vector<double> mask = mask_of(plate, where, picture);
  EXPECT_EQ(*std::min_element(mask.begin(), mask.end()), 0);
  EXPECT_GT(*std::max_element(mask.begin(), mask.end()), 0.9);
  where = {};
  where.attribute = "fade";
  mask = mask_of(plate, where);
  for (std::size_t f = 0; f < mask.size(); ++f) {
    const Triangle& t = plate.triangles[f];
    const bool at_zero = std::any_of(t.begin(), t.end(), [&](std::int32_t v) {
      return plate.vertex_attributes.back().values[v] == 0;
    });
    EXPECT_EQ(mask[f] == 0, at_zero);
  }
}

TEST(ACrackMask, OutsideOfZeroToOneIsRefused) {
  SurfaceMesh plate = halves();
  plate.vertex_attributes.push_back({"bytes", 1, std::vector<double>(plate.positions.size(), 255)});
  WhereParameters where;
  where.attribute = "bytes";
  EXPECT_NE(error_of([&] { mask_of(plate, where); }).find("0 ... 1"), std::string::npos);
}

// Length of cracks per area in bands of equal width across the fade, the mean over seeds.
using Bands = std::array<double, 5>;

Bands densities(const Recipe& recipe, int seeds) {
  Bands density{};
  for (int seed = 1; seed <= seeds; ++seed) {
    Recipe seeded = recipe;
    seeded.simulation.seed = static_cast<std::uint64_t>(seed);
    const LineSet lines = lines_of(halves("plate?n=50&jitter=0.3"), seeded);
    for (const auto& [a, b] : lines.edges) {
      const Vec3 &p = lines.points[a], &q = lines.points[b];
      const int band = std::clamp(static_cast<int>(5 * ((p.x() + q.x()) / 2 + 0.5)), 0, 4);
      density[static_cast<std::size_t>(band)] += (q - p).norm() / (0.2 * seeds);
    }
  }
  return density;
}

TEST(AFadingMask, LetsTheDensityOfCracksOnlyFallAndNeverRiseAboveTheUnmaskedOne) {
  constexpr int seeds = 4;
  constexpr double noise = 0.1;  // twice the standard error of a band's mean of four seeds, about
  const Bands all = densities(mud_recipe({}), seeds);
  const Bands faded = densities(mud_recipe({"where.attribute=fade"}), seeds);
  double before = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double share = faded[i] / all[i];
    EXPECT_LT(share, 1 + noise) << i;
    EXPECT_GT(share, before - noise) << i;
    before = share;
  }
  EXPECT_LT(faded[0], 0.1 * all[0]);
  EXPECT_GT(faded[4], 0.7 * all[4]);
}

TEST(FreeSpacing, CountsWhatCracksFreelyAlone) {
  const SurfaceMesh plate = halves("plate?n=40&jitter=0.3");
  Recipe recipe = mud_recipe({"where.attribute=half", "mesh.edge=keep", "layer.rounds=3"});
  const double diagonal = std::sqrt(2.0);
  const SpacedRun run = run_to_spacing(plate, recipe, {}, {});
  const TriangleMesh& mesh = run.last.simulation->mesh();
  const double spacing = free_spacing(mesh, find_components(mesh), run.surface.mask);
  EXPECT_NEAR(spacing / (0.12 * diagonal), 1, 0.15);
}

}  // namespace
}  // namespace craze
