// From a cracked simulation surface onto other triangles of the same shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "craze/engine/asset/carry_onto_asset.h"
#include "craze/mesh/closest_point.h"
#include "craze/mesh/components.h"
#include "craze/mesh/validate.h"
#include "craze/shapes.h"
#include "engine/asset_cases.h"
#include "engine/cut_checks.h"

namespace craze {
namespace {

/// A mesh cut along some of its edges, and the network of these cuts.
struct Cracked {
  TriangleMesh mesh;
  CrackNetwork network;

  template <class IsCrack>
  Cracked(const SurfaceMesh& surface, IsCrack&& is_crack)
      : mesh(surface.positions, surface.triangles) {
    std::map<std::int32_t, std::int32_t> node;
    const auto node_at = [&](std::int32_t root, std::int32_t face) {
      const auto [slot, fresh] =
          node.try_emplace(root, static_cast<std::int32_t>(network.nodes.size()));
      if (fresh) {
        network.nodes.push_back(
            {mesh.position(root), Vec3::Zero(), face, JunctionKind::bend, root});
      }
      return slot->second;
    };
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      if (mesh.is_open(h)) continue;
      if (!is_crack(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)))) continue;
      const std::int32_t a = mesh.root(mesh.from(h)), b = mesh.root(mesh.to(h));
      mesh.cut(h, static_cast<std::int32_t>(network.edges.size()));
      CrackEdge edge;
      edge.a = node_at(a, h / 3);
      edge.b = node_at(b, h / 3);
      edge.face = h / 3;
      network.edges.push_back(edge);
    }
  }
};

/// How many nodes a network has of each number of edges.
std::array<int, 8> degrees(const CrackNetwork& network) {
  std::vector<std::size_t> degree(network.nodes.size(), 0);
  for (const CrackEdge& e : network.edges) {
    ++degree[e.a];
    ++degree[e.b];
  }
  std::array<int, 8> count{};
  for (const std::size_t d : degree) ++count[std::min<std::size_t>(d, 7)];
  return count;
}

/// Per face of `mesh` the face of the asset under its middle.
std::vector<std::int32_t> faces_below(const SurfaceMesh& mesh, const SurfaceMesh& asset) {
  const ClosestPoint tree(asset.positions, asset.triangles);
  std::vector<std::int32_t> faces;
  for (const Triangle& t : mesh.triangles) {
    ClosestPoint::Filter filter;
    filter.normal = test::area_vector(mesh.positions, t);
    const Vec3 sum = mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]];
    faces.push_back(tree.find(sum / 3, filter).face);
  }
  return faces;
}

/// Twelve triangles, or a grid that fits none of the simulation's.
class CarriedRing : public ::testing::TestWithParam<std::string> {};

TEST_P(CarriedRing, PartsTheAssetAndEachSideKeepsItsOwnDisplacement) {
  const SurfaceMesh fine = make_shape("cube?n=8"), asset = make_shape(GetParam());
  const double level = 0.125;
  const Cracked cracked(fine, [&](const Vec3& p, const Vec3& q) {
    return std::abs(p.z() - level) < 1e-9 && std::abs(q.z() - level) < 1e-9;
  });
  const Components parts = find_components(cracked.mesh);
  ASSERT_EQ(parts.count, 2);
  std::vector<Vec3> displacement(cracked.mesh.vertex_count());
  const auto moved_by = [](bool upper, const Vec3& p) {
    return upper ? Vec3(0, 0, 1 + p.x()) : Vec3(0, p.y(), -2);
  };
  for (std::int32_t f = 0; f < cracked.mesh.face_count(); ++f) {
    const Triangle& t = cracked.mesh.triangle(f);
    double height = 0;
    for (const std::int32_t v : t) height += cracked.mesh.position(v).z() / 3;
    for (const std::int32_t v : t) {
      displacement[v] = moved_by(height > level, cracked.mesh.position(v));
    }
  }
  const std::vector<std::int32_t> below = faces_below(fine, asset);
  const CrackedAsset made = carry_onto_asset(
      asset, {cracked.mesh, cracked.network, displacement, parts.face, below}, 0, {});
  test::check_cut(asset, made.cut);
  test::check_chains(made.curves, made.cut, 1.0001, 1e-6);
  EXPECT_EQ(made.cut.report.traced.lost, 0);
  EXPECT_EQ(find_components(made.mesh).count, 2);
  ASSERT_EQ(made.displacement.size(), made.cut.positions.size());
  for (const Triangle& t : made.cut.triangles) {
    double height = 0;
    for (const std::int32_t v : t) height += made.cut.positions[v].z() / 3;
    for (const std::int32_t v : t) {
      const Vec3 expected = moved_by(height > level, made.cut.positions[v]);
      EXPECT_LE((made.displacement[v] - expected).norm(), 1e-5);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Assets, CarriedRing,
                         ::testing::Values("cube?n=1", "cube?n=3", "cube?n=7", "cube?n=30"));

TEST(CarriedCracks, OnTheirOwnMeshSplitNothing) {
  const SurfaceMesh surface = make_shape("sphere?n=6");
  const Cracked cracked(surface, [](const Vec3& p, const Vec3& q) {
    return p.z() > 0.2 && q.z() > 0.2 && p.x() > 0 && q.x() > 0;
  });
  std::vector<std::int32_t> own(surface.triangles.size());
  std::iota(own.begin(), own.end(), 0);
  const std::vector<Vec3> still(cracked.mesh.vertex_count(), Vec3::Zero());
  const std::vector<std::int32_t> parts = find_components(cracked.mesh).face;
  const CrackedAsset made =
      carry_onto_asset(surface, {cracked.mesh, cracked.network, still, parts, own}, 0, {});
  EXPECT_EQ(made.cut.report.split_faces, 0);
  EXPECT_EQ(made.cut.triangles.size(), surface.triangles.size());
  EXPECT_EQ(made.cut.positions.size(), cracked.mesh.positions().size());
  EXPECT_EQ(made.cut.edges.size(), cracked.network.edges.size());
}

/// Points of a unit sphere, spread evenly.
std::vector<Vec3> directions(int n) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z);
    points.emplace_back(r * std::cos(2.4 * i), r * std::sin(2.4 * i), z);
  }
  return points;
}

/// A sphere with bumps that lean over.
SurfaceMesh with_bumps(const SurfaceMesh& sphere) {
  SurfaceMesh mesh = sphere;
  for (Vec3& p : mesh.positions) {
    const Vec3 wave(std::sin(31 * p.y()), std::sin(29 * p.z()), std::sin(37 * p.x()));
    p += 0.12 * wave.sum() * p + 0.08 * p.cross(wave);
  }
  return mesh;
}

TEST(CarriedCracks, OfASurfaceWithoutTheBumpsMeetAsTheyDidAndPartTheSamePieces) {
  const SurfaceMesh simulated = make_shape("sphere?n=14"), smooth = make_shape("sphere?n=45");
  const SurfaceMesh asset = with_bumps(smooth);
  const std::vector<Vec3> middles = directions(25);
  const auto nearest = [&](const Triangle& t) {
    const Vec3 sum =
        simulated.positions[t[0]] + simulated.positions[t[1]] + simulated.positions[t[2]];
    return std::max_element(middles.begin(), middles.end(),
                            [&](const Vec3& a, const Vec3& b) { return a.dot(sum) < b.dot(sum); }) -
           middles.begin();
  };
  const TriangleMesh uncut(simulated.positions, simulated.triangles);
  std::set<std::array<double, 3>> cracks;  // middles of edges between places of other middles
  for (std::int32_t h = 0; h < 3 * uncut.face_count(); ++h) {
    if (nearest(uncut.triangle(h / 3)) == nearest(uncut.triangle(uncut.opposite(h) / 3))) continue;
    const Vec3 m = uncut.position(uncut.from(h)) + uncut.position(uncut.to(h));
    cracks.insert({m[0], m[1], m[2]});
  }
  const Cracked cracked(simulated, [&](const Vec3& p, const Vec3& q) {
    const Vec3 m = p + q;
    return cracks.count({m[0], m[1], m[2]}) > 0;
  });
  const Components parts = find_components(cracked.mesh);
  ASSERT_GE(parts.count, 25);
  const std::vector<Vec3> still(cracked.mesh.vertex_count(), Vec3::Zero());
  const std::vector<std::int32_t> below = faces_below(simulated, smooth);
  const CrackedAsset made = carry_onto_asset(
      asset, {cracked.mesh, cracked.network, still, parts.face, below, &smooth.positions}, 0, {});
  test::check_cut(asset, made.cut);
  EXPECT_EQ(made.cut.report.traced.lost, 0);
  EXPECT_EQ(find_components(made.mesh).count, parts.count);
  EXPECT_EQ(degrees(made.network)[1], 0);  // free ends
  EXPECT_EQ(degrees(made.network)[3], degrees(cracked.network)[3]);
}

TEST(CarriedCracks, StayOnTheirSideOfAThinWall) {
  const SurfaceMesh wall = test::needles(make_shape("cube?n=6"), 1e-3);
  std::int32_t top = -1;
  for (std::size_t f = 0; f < wall.triangles.size(); ++f) {
    const Vec3 n = test::area_vector(wall.positions, wall.triangles[f]);
    if (n.y() > 0.9 * n.norm() && n.norm() > 0.01) top = static_cast<std::int32_t>(f);
  }
  ASSERT_GE(top, 0);
  CrackNetwork network;
  for (const double x : {-0.2, 0.0, 0.2}) {  // nearer to the other side
    network.nodes.push_back({Vec3(x, -4e-4, 0.1), Vec3::UnitY(), 0, JunctionKind::bend, 0});
  }
  const CrackCurves curves =
      crack_curves(network, wall, AssetTopology(wall.positions, wall.triangles), {top});
  for (const SurfacePoint& p : curves.points) {
    EXPECT_GT(test::area_vector(wall.positions, wall.triangles[p.face]).y(), 0);
  }
}

// The same cuts made by TriangleMesh, which knows nothing of how vertices were copied here.
TEST(ACrackMesh, PartsTheSameVertices) {
  for (const std::string name : {"cube?n=2", "torus?n=12", "plate?n=5&jitter=0.3", "disc?n=12"}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      SCOPED_TRACE(name + " seed " + std::to_string(seed));
      const SurfaceMesh asset = make_shape(name);
      Random random(seed);
      CutAsset cut = test::cut(asset, test::random_curves(asset, random, {}), {});
      const CutAsset before = cut;
      const TriangleMesh mesh = crack_mesh(cut);
      const auto faults = validate(mesh);
      ASSERT_TRUE(faults.empty()) << faults.front();
      ASSERT_EQ(mesh.positions().size(), cut.positions.size());
      ASSERT_EQ(mesh.triangles(), cut.triangles);
      std::vector<std::int32_t> number(before.positions.size(), -1);
      for (std::size_t f = 0; f < cut.triangles.size(); ++f) {
        for (int i = 0; i < 3; ++i) {
          const std::int32_t v = cut.triangles[f][i], was = before.triangles[f][i];
          ASSERT_TRUE(number[was] == -1 || number[was] == v) << "parted otherwise";
          number[was] = v;
          ASSERT_EQ(mesh.position(v), before.positions[was]);
        }
      }
      for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) ASSERT_EQ(mesh.root(v), cut.root[v]);
      for (const CutEdge& e : cut.edges) {
        for (const std::int32_t h : e.side) {
          ASSERT_TRUE(h < 0 || mesh.is_open(h));
        }
      }
    }
  }
}

}  // namespace
}  // namespace craze
