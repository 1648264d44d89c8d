// Recipes of random values, edges and contradictions included, on small meshes of every kind: each
// ends within its bound in finite numbers and a valid mesh, or is refused in one line.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string>

#include "craze/base/random.h"
#include "craze/engine.h"
#include "craze/error.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/mesh/validate.h"
#include "craze/products.h"
#include "craze/recipe/length_text.h"
#include "craze/recipe/own_lengths.h"
#include "craze/shapes.h"
#include "engine/edge_values.h"

namespace craze {
namespace {

constexpr double seconds_of_processor = 60;  // far above what a run of this size needs

SurfaceMesh moved(SurfaceMesh mesh, double scale, const Vec3& by) {
  for (Vec3& p : mesh.positions) p = scale * p + by;
  return mesh;
}

SurfaceMesh one_triangle() {
  SurfaceMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

SurfaceMesh joined(SurfaceMesh a, const SurfaceMesh& b) {
  const auto n = static_cast<std::int32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  a.corner_uvs.clear();
  a.corner_normals.clear();
  a.source_faces.clear();
  return a;
}

/// Every other triangle turned over, some doubled, one without area.
SurfaceMesh broken(SurfaceMesh mesh) {
  for (std::size_t f = 0; f < mesh.triangles.size(); f += 2) {
    std::swap(mesh.triangles[f][0], mesh.triangles[f][1]);
  }
  mesh.triangles.push_back(mesh.triangles.front());
  mesh.triangles.push_back({0, 0, 1});
  mesh.corner_uvs.clear();
  mesh.corner_normals.clear();
  mesh.source_faces.clear();
  return mesh;
}

std::vector<SurfaceMesh> small_meshes() {
  std::vector<SurfaceMesh> meshes;
  for (const char* shape :
       {"plate?n=1", "plate?n=8", "plate?n=9&jitter=0.4", "strip?n=6", "disc?n=8", "cube?n=1",
        "cube?n=4", "sphere?n=2", "sphere?n=8", "cylinder?n=8", "torus?n=8", "bowl?n=8", "cup?n=24",
        "bumps?n=24", "drape?n=24"}) {
    meshes.push_back(make_shape(shape));
  }
  meshes.push_back(one_triangle());
  meshes.push_back(moved(make_shape("plate?n=6"), 1e-6, {0, 0, 0}));
  meshes.push_back(moved(make_shape("sphere?n=6"), 1e6, {0, 0, 0}));
  meshes.push_back(moved(make_shape("plate?n=6"), 1, {1e6, -1e6, 1e6}));
  meshes.push_back(joined(make_shape("cube?n=2"), moved(make_shape("cube?n=2"), 1, {3, 0, 0})));
  meshes.push_back(joined(make_shape("plate?n=4"), make_shape("plate?n=3")));
  meshes.push_back(broken(make_shape("sphere?n=5")));
  meshes.push_back(broken(make_shape("plate?n=5")));
  meshes.push_back(joined(one_triangle(), make_shape("torus?n=6")));
  return meshes;
}

/// A value somewhere in the range, small ones as likely as large ones.
ParameterValue inside(const Parameter& p, Random& random) {
  const auto number = [&] {
    const double size = std::pow(10, random.uniform(-3, 1));
    return test::clamped(p.range, random.below(5) == 0 ? -size : size);
  };
  switch (p.type) {
    case ParameterType::integer:
      return static_cast<std::int64_t>(test::clamped(p.range, std::floor(number() + 2)));
    case ParameterType::vec2:
      return std::vector<double>{number(), number()};
    case ParameterType::vec3:
      return std::vector<double>{number(), number(), number()};
    case ParameterType::tensor6:
      return std::vector<double>{number(), number(), number(), number(), number(), number()};
    case ParameterType::names:
      return std::vector<std::string>{random.below(2) == 0 ? "*" : "missing"};
    case ParameterType::length:
      if (random.below(4) == 0) return format_length({number(), LengthUnit::percent});
      return number();
    case ParameterType::string:
      return std::string(random.below(2) == 0 ? "paint" : "missing");
    default:
      return number();
  }
}

/// One key in four is set, half of those to an edge of its range.
Recipe random_recipe(Random& random, std::string& text) {
  Recipe recipe;
  if (random.below(2) == 0) recipe.simulation.layer.relative_spacing = random.uniform(0.1, 0.6);
  recipe.simulation.impacts.resize(random.below(3));
  for (const Parameter& p : parameter_table()) {
    if (random.below(4) != 0 || (p.repeated() && recipe.simulation.impacts.empty())) continue;
    const std::vector<ParameterValue> edges = test::edges_of(p);
    const bool edge = !edges.empty() && (random.below(2) == 0 || p.type == ParameterType::choice ||
                                         p.type == ParameterType::boolean);
    const ParameterValue value = edge ? edges[random.below(edges.size())] : inside(p, random);
    try {
      check_value(p, value, p.key, "test");
    } catch (const Error&) {
      continue;
    }
    p.set(recipe, 0, value);
    text += p.key + " = " + format_value(value) + "\n";
  }
  // Each of many rounds and cycles is a run like one of the others here.
  EvolutionParameters& evolution = recipe.simulation.evolution;
  evolution.cycles = std::min<std::int64_t>(evolution.cycles, 2);
  recipe.simulation.layer.rounds = std::min<std::int64_t>(recipe.simulation.layer.rounds, 2);
  return recipe;
}

/// Of what would make some ten thousand triangles of a small mesh, the mesh as it is.
void keep_small(Recipe& recipe, double diagonal) {
  const Recipe own = with_own_lengths(recipe, {diagonal, 1});
  const LayerParameters& layer = own.simulation.layer;
  const bool fine_layer = (layer.spacing > 0 && layer.spacing < 0.1 * diagonal) ||
                          (layer.relative_spacing > 0 && layer.relative_spacing < 0.1) ||
                          (layer.screening_length > 0 && layer.screening_length < 0.1 * diagonal);
  EdgeLength& edge = recipe.mesh.edge;
  const bool fine_edge =
      edge.kind == EdgeLength::Kind::given && own.mesh.edge.length < 0.03 * diagonal;
  if (fine_layer || fine_edge) edge = {EdgeLength::Kind::keep, 0};
}

void expect_finite(const SurfaceMesh& mesh, const std::string& what) {
  for (const Vec3& p : mesh.positions) {
    ASSERT_TRUE(p.allFinite()) << what;
  }
  for (const auto* attributes : {&mesh.vertex_attributes, &mesh.face_attributes}) {
    for (const Attribute& a : *attributes) {
      for (const double x : a.values) ASSERT_TRUE(std::isfinite(x)) << what << a.name;
    }
  }
}

void run_and_expect(const SurfaceMesh& mesh, const Recipe& recipe, const std::string& what) {
  const std::clock_t start = std::clock();
  Context context;
  context.threads = 1;
  context.cancelled = [&] {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC > seconds_of_processor;
  };
  try {
    CrackOptions options;
    options.max_cracks = 40;
    const Result result =
        crack({std::make_shared<const SurfaceMesh>(mesh), {}, "mesh"}, recipe, options, context);
    EXPECT_NE(result.report().stop_reason, "cancelled") << what;
    const SurfaceMesh cut = cut_mesh(result, context);
    EXPECT_TRUE(validate(TriangleMesh(cut.positions, cut.triangles)).empty()) << what;
    expect_finite(cut, what);
    const Opening opening(result, recipe.post, context);
    expect_finite(opening.mesh(), what);
  } catch (const Error& e) {
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << what;
  } catch (const Cancelled&) {
    ADD_FAILURE() << what << "takes longer than it may";
  }
}

/// Recipes by number: the seed is the number, so that one that fails can be run again alone.
void try_recipes(std::uint64_t first, std::uint64_t count) {
  std::vector<SurfaceMesh> meshes = small_meshes();
  for (SurfaceMesh& mesh : meshes) {
    std::vector<double> paint(mesh.positions.size());
    for (std::size_t v = 0; v < paint.size(); ++v) paint[v] = static_cast<double>(v % 3) / 2;
    mesh.vertex_attributes.push_back({"paint", 1, std::move(paint)});
  }
  for (std::uint64_t k = first; k < first + count; ++k) {
    Random random(k);
    const std::size_t m = random.below(meshes.size());
    std::string what = "recipe " + std::to_string(k) + ", mesh " + std::to_string(m) + ":\n";
    Recipe recipe = random_recipe(random, what);
    keep_small(recipe, bounding_diagonal(meshes[m].positions));
    run_and_expect(meshes[m], recipe, what);
  }
}

TEST(RandomRecipes, EndInFiniteNumbersAndValidMeshesOrOneLine) {
  try_recipes(0, 200);
}

TEST(RandomRecipesAtLength, EndInFiniteNumbersAndValidMeshesOrOneLine) {
  try_recipes(200, 300);
}

}  // namespace
}  // namespace craze
