// Solids of meshes that are cut at random, with sides that were split on one side only.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <random>
#include <set>

#include "craze/mesh/components.h"
#include "craze/mesh/self_intersection.h"
#include "craze/products/solids/inner_directions.h"
#include "craze/products/solids/solids.h"
#include "craze/shapes.h"

namespace craze {
namespace {

/// A surface cut at random, and which way is out of it.
struct Cut {
  TriangleMesh mesh;
  std::vector<Vec3> outwards;
};

/// Cuts a share of the edges, then splits one side of some of them, once.
Cut cut_at_random(const SurfaceMesh& surface, double share, double splits, unsigned seed) {
  Cut cut{TriangleMesh(surface.positions, surface.triangles),
          inner_directions(surface.positions, surface.triangles)};
  TriangleMesh& mesh = cut.mesh;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> chance(0, 1);
  std::int32_t label = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (!mesh.is_open(h) && mesh.opposite(h) < h && chance(random) < share) mesh.cut(h, label++);
  }
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.root(v) != v) cut.outwards.push_back(cut.outwards[mesh.root(v)]);
  }
  std::set<std::int32_t> done;  // labels
  const std::int32_t halfedges = 3 * mesh.face_count();
  for (std::int32_t h = 0; h < halfedges; ++h) {
    if (mesh.crack_of(h) < 0 || chance(random) > splits) continue;
    if (!done.insert(mesh.crack_of(h)).second) continue;
    const double t = 0.3 + 0.4 * chance(random);
    const Vec3 between = (1 - t) * cut.outwards[mesh.from(h)] + t * cut.outwards[mesh.to(h)];
    mesh.split_edge(h, t);
    cut.outwards.push_back(between);
  }
  return cut;
}

OpenedMesh shut(const TriangleMesh& mesh) {
  OpenedMesh opened;
  opened.mesh.positions = mesh.positions();
  opened.mesh.triangles = mesh.triangles();
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) opened.vertex_of.push_back(v);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) opened.face_of.push_back(f);
  opened.beside = opened.face_of;
  return opened;
}

struct Made {
  TriangleMesh mesh;
  OpenedMesh opened;
  std::vector<std::string> warnings;
};

Made made_of(const SurfaceMesh& surface, double share, double splits, unsigned seed,
             const SolidOptions& options) {
  Cut cut = cut_at_random(surface, share, splits, seed);
  Made made{std::move(cut.mesh), {}, {}};
  made.opened = shut(made.mesh);
  made.warnings = make_solid(made.mesh, crack_sites(made.mesh), std::move(cut.outwards), options,
                             made.opened, {});
  return made;
}

/// By face: the fragment that it is part of, cores last.
std::vector<std::int32_t> solid_of(const Made& made) {
  const Components parts = find_components(made.mesh);
  std::vector<std::int32_t> of;
  for (const std::int32_t f : made.opened.beside) of.push_back(parts.face[f]);
  const auto begin = static_cast<std::size_t>(made.opened.solid->core_begin);
  for (std::size_t f = begin; f < of.size(); ++f) {
    of[f] = parts.count + made.opened.solid->core[f - begin];
  }
  return of;
}

struct Sum {
  std::map<std::pair<std::int32_t, std::int32_t>, int> uses;
  double six_volumes = 0;
};

std::map<std::int32_t, Sum> sums(const Made& made) {
  std::map<std::int32_t, Sum> sums;
  const std::vector<std::int32_t> of = solid_of(made);
  for (std::size_t f = 0; f < of.size(); ++f) {
    const Triangle& t = made.opened.mesh.triangles[f];
    const auto& p = made.opened.mesh.positions;
    sums[of[f]].six_volumes += p[t[0]].cross(p[t[1]]).dot(p[t[2]]);
    for (std::size_t i = 0; i < 3; ++i) ++sums[of[f]].uses[{t[i], t[(i + 1) % 3]}];
  }
  return sums;
}

double area(const TriangleMesh& mesh) {
  return mesh.total_area();
}

TEST(RandomCuts, GiveClosedSolidsThatDoNotMeet) {
  const char* const shapes[] = {"plate?n=6&jitter=0.3", "cup?n=24", "sphere?n=6", "torus", "cube"};
  EXPECT_TRUE(rc::check([&] {
    const char* shape = shapes[*rc::gen::inRange<std::size_t>(0, std::size(shapes))];
    const double share = *rc::gen::inRange(0, 10) / 10.0;
    const double thickness = std::pow(10, *rc::gen::inRange(-40, 10) / 10.0);
    const auto seed = *rc::gen::inRange<unsigned>(0, 1000000);
    const double splits = *rc::gen::element(0.0, 0.3);
    SolidOptions options;
    options.thickness = thickness;
    options.core = *rc::gen::element(false, true);
    RC_LOG() << shape << ", share " << share << ", thickness " << thickness << ", seed " << seed
             << ", splits " << splits << ", core " << options.core;
    const Made made = made_of(make_shape(shape), share, splits, seed, options);
    for (const auto& [number, sum] : sums(made)) {
      for (const auto& [edge, count] : sum.uses) {
        const auto back = sum.uses.find({edge.second, edge.first});
        RC_ASSERT(back != sum.uses.end());
        RC_ASSERT(back->second == count);
      }
      RC_ASSERT(sum.six_volumes > 0);
    }
    const std::vector<std::int32_t> of = solid_of(made);
    for (const auto& [f, g] :
         self_intersections(made.opened.mesh.positions, made.opened.mesh.triangles)) {
      RC_ASSERT(of[f] == of[g]);
    }
  }));
}

TEST(RandomCuts, OfAPlateChangeNothingOfItsVolume) {
  SolidOptions options;
  options.thickness = 0.1;
  for (const double share : {0.0, 0.3, 0.7, 1.0}) {
    const Made made = made_of(make_shape("plate?n=6&jitter=0.3"), share, 0.3, 5, options);
    EXPECT_TRUE(made.warnings.empty());
    double six = 0;
    for (const auto& [number, sum] : sums(made)) six += sum.six_volumes;
    EXPECT_NEAR(six / 6, 0.1 * area(made.mesh), 1e-12);
  }
}

TEST(RandomCuts, WithACoreFillTheWholeShape) {
  SolidOptions options;
  options.thickness = 0.1;
  options.core = true;
  const SurfaceMesh ball = make_shape("sphere?n=8");
  double whole = 0;
  for (const Triangle& t : ball.triangles) {
    whole += ball.positions[t[0]].cross(ball.positions[t[1]]).dot(ball.positions[t[2]]);
  }
  const Made made = made_of(ball, 0.5, 0.3, 3, options);
  double six = 0;
  for (const auto& [number, sum] : sums(made)) six += sum.six_volumes;
  EXPECT_NEAR(six, whole, 1e-9 * whole);
}

}  // namespace
}  // namespace craze
