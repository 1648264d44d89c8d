// post.roughness: lines of cracks that are rough in themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/engine/roughness/crack_chains.h"
#include "craze/engine/roughness/rough_network.h"
#include "craze/engine/simulation_surface.h"
#include "craze/error.h"
#include "craze/mesh/validate.h"
#include "craze/presets.h"
#include "craze/products.h"
#include "craze/products/statistics/statistics.h"
#include "craze/shapes.h"
#include "mud_run.h"
#include "recipe_with.h"

namespace craze {
namespace {

using test::mud_run;
using test::plate;

double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Pairs of edges in the plane that cross, by their signs; edges that meet at a node do not.
int crossings(const LineSet& lines) {
  double cell = 0;
  for (const auto& e : lines.edges) {
    cell = std::max(cell, (lines.points[e[1]] - lines.points[e[0]]).norm());
  }
  std::map<std::array<long, 2>, std::vector<std::size_t>> cells;
  for (std::size_t e = 0; e < lines.edges.size(); ++e) {
    const Vec3 &a = lines.points[lines.edges[e][0]], &b = lines.points[lines.edges[e][1]];
    for (long x = std::lround(std::floor(std::min(a.x(), b.x()) / cell));
         x <= std::lround(std::floor(std::max(a.x(), b.x()) / cell)); ++x) {
      for (long y = std::lround(std::floor(std::min(a.y(), b.y()) / cell));
           y <= std::lround(std::floor(std::max(a.y(), b.y()) / cell)); ++y) {
        cells[{x, y}].push_back(e);
      }
    }
  }
  int count = 0;
  const auto cross = [&](std::size_t i, std::size_t j) {
    const auto &e = lines.edges[i], &f = lines.edges[j];
    if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]) return false;
    const Vec3 &a = lines.points[e[0]], &b = lines.points[e[1]], &c = lines.points[f[0]],
               &d = lines.points[f[1]];
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  };
  for (const auto& entry : cells) {
    const std::vector<std::size_t>& in = entry.second;
    for (std::size_t i = 0; i < in.size(); ++i) {
      for (std::size_t j = i + 1; j < in.size(); ++j) count += cross(in[i], in[j]) ? 1 : 0;
    }
  }
  return count;
}

std::array<int, 3> node_counts(const Result& result) {
  std::array<int, 3> counts{};  // tips, junctions, ends at the border
  for (const CrackNode& node : result.state().network.nodes) {
    counts[0] += node.kind == JunctionKind::end;
    counts[1] += node.kind == JunctionKind::junction;
    counts[2] += node.kind == JunctionKind::border;
  }
  return counts;
}

double tortuosity(const Result& result) {
  StatisticsOptions options;
  options.bootstrap.resamples = 0;
  const CrackedSurface& state = result.state();
  return compute_statistics(graph_from_network(state.network, state.mesh()), options)
      .tortuosity.value;
}

TEST(Roughness, IsAsMuchAsAskedForOverTheUsualLengthOfACrack) {
  const Result smooth = mud_run(plate, {});
  const CrackNetwork& network = smooth.state().network;
  const TriangleMesh& mesh = smooth.state().mesh();
  const double usual = usual_length(crack_chains(network));
  const RoughnessOptions options{0.01 * usual, 0.75, usual / 256, 7};
  const RoughNetwork rough = roughen(network, mesh, options, {});
  double sum = 0, count = 0;
  for (const CrackChain& chain : crack_chains(rough.network)) {
    // How far each point was moved, to the left of the chain.
    std::vector<double> moved;
    for (std::size_t i = 0; i < chain.edges.size(); ++i) {
      const SmoothPiece& piece = rough.pieces[chain.edges[i]];
      const CrackEdge &edge = rough.network.edges[chain.edges[i]],
                      &parent = network.edges[piece.edge];
      const bool forward = edge.a == chain.nodes[i];
      const Vec3 &a = network.nodes[parent.a].position, &b = network.nodes[parent.b].position;
      const Vec3 before = a + piece.shares[forward ? 0 : 1] * (b - a);
      const Vec3 by = rough.network.nodes[chain.nodes[i]].position - before;
      moved.push_back((forward ? 1 : -1) * Vec3::UnitZ().cross(b - a).normalized().dot(by));
    }
    const std::size_t lag = moved.size() / 16;
    const double expected = options.amplitude * std::pow(chain.length / 16 / usual, 0.75);
    for (std::size_t i = 0; lag > 0 && i + lag < moved.size(); ++i) {
      const double difference = (moved[i + lag] - moved[i]) / expected;
      sum += difference * difference;
      ++count;
    }
  }
  EXPECT_NEAR(std::sqrt(sum / count), 1, 0.1);
}

TEST(Roughness, MakesTheCracksOfMudLongerThanTheirChords) {
  const double smooth = tortuosity(mud_run(plate, {}));
  const double rough =
      tortuosity(mud_run(plate, {"post.roughness=0.01", "post.roughness_step=0.0005"}));
  EXPECT_LT(smooth, 1.01);
  EXPECT_GT(rough, 1.02);
  EXPECT_LT(rough, 1.2);
}

TEST(Roughness, RelativeToTheUsualLengthIsThatLength) {
  const Result smooth = mud_run(plate, {});
  const double usual = usual_length(crack_chains(crack_network(*smooth.state().simulation)));
  const Result relative = mud_run(plate, {"post.relative_roughness=0.06"});
  EXPECT_NEAR(relative.report().recipe.post.roughness, 0.06 * usual, 1e-12);
  const Result given = mud_run(plate, {"post.relative_roughness=0.06", "post.roughness=0.001"});
  EXPECT_EQ(given.report().recipe.post.roughness, 0.001);
}

TEST(Roughness, OfThePresetMudIsSeenAndCostsFewerThanTwiceTheTriangles) {
  Recipe recipe = read_preset("mud");
  recipe.simulation.layer.spacing = 0.14;
  const auto run = [&] {
    return crack({std::make_shared<SurfaceMesh>(make_shape(plate)), {}, plate}, recipe, {}, {});
  };
  const Result rough = run();
  recipe.post.relative_roughness = 0;
  const Result smooth = run();
  EXPECT_GT(tortuosity(rough), 1.005);
  EXPECT_GT(tortuosity(rough), tortuosity(smooth) + 0.003);
  EXPECT_LT(rough.state().mesh().face_count(), 2 * smooth.state().mesh().face_count());
  EXPECT_EQ(rough.report().cracks.fragments, smooth.report().cracks.fragments);
}

TEST(Roughness, TakesNoCrackIntoWhatIsClosed) {
  // Cracks run as near as they like to where none may be: nothing of them gets across.
  const Result smooth = mud_run(plate, {});
  const Simulation& simulation = *smooth.state().simulation;
  const CrackNetwork network = crack_network(simulation);
  const TriangleMesh& mesh = simulation.mesh();
  std::int32_t last = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) last = std::max(last, mesh.source_face(f));
  std::vector<std::uint8_t> closed(static_cast<std::size_t>(last) + 1, 1);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      // Open is what lies beside a crack.
      const std::int32_t v = mesh.from(3 * f + i);
      for (const CrackEdge& e : network.edges) {
        const bool touches = (network.nodes[e.a].position - mesh.position(v)).norm() < 1e-9 ||
                             (network.nodes[e.b].position - mesh.position(v)).norm() < 1e-9;
        if (touches) closed[static_cast<std::size_t>(mesh.source_face(f))] = 0;
      }
    }
  }
  RoughnessOptions options{0.02, 0.75, 0.002, 7};
  const auto points_in_closed = [&] {
    int count = 0;
    for (const CrackNode& n : roughen(network, mesh, options, {}).network.nodes) {
      for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
        if (closed[static_cast<std::size_t>(mesh.source_face(f))] == 0) continue;
        const Vec3 &a = mesh.position(mesh.from(3 * f)), &b = mesh.position(mesh.from(3 * f + 1)),
                   &c = mesh.position(mesh.from(3 * f + 2));
        count +=
            turn(a, b, n.position) > 0 && turn(b, c, n.position) > 0 && turn(c, a, n.position) > 0;
      }
    }
    return count;
  };
  EXPECT_GT(points_in_closed(), 0);
  options.closed = closed;
  EXPECT_EQ(points_in_closed(), 0);
}

TEST(Roughness, LeavesJunctionsTipsAndFragmentsAsTheyAre) {
  for (const char* const seed : {"1", "2", "4", "5", "6", "7", "8", "10", "16", "20"}) {
    const Result smooth = mud_run(plate, {std::string("seed=") + seed});
    for (const double exponent : {0.01, 0.3, 0.8, 0.99}) {
      PostParameters post = asked_post(smooth);
      post.roughness = 0.01;
      post.roughness_exponent = exponent;
      const Result rough = with_post(smooth, post, {});
      EXPECT_EQ(node_counts(rough), node_counts(smooth)) << seed << ", " << exponent;
      EXPECT_EQ(rough.report().cracks.fragments, smooth.report().cracks.fragments)
          << seed << ", " << exponent;
    }
  }
}

TEST(Roughness, NeverMakesLinesCross) {
  for (const char* const amplitude : {"0.000000001", "0.002", "0.01", "0.05", "0.3", "1e6"}) {
    for (const char* const seed : {"1", "2", "3"}) {
      const Result rough =
          mud_run(plate, {std::string("post.roughness=") + amplitude, std::string("seed=") + seed});
      EXPECT_EQ(crossings(crack_lines(rough)), 0) << amplitude;
      EXPECT_EQ(validate(rough.state().mesh()), std::vector<std::string>()) << amplitude;
      const SurfaceMesh flat = make_shape(plate);
      EXPECT_NEAR(rough.state().mesh().total_area(),
                  TriangleMesh(flat.positions, flat.triangles).total_area(), 1e-9);
    }
  }
}

TEST(Roughness, IsCutIntoTheAssetAndKeepsItsAreaAndItsPieces) {
  for (const char* const amplitude : {"0.005", "0.02", "1e6"}) {
    const Result smooth = mud_run("cup?n=40", {"layer.spacing=0.3"});
    const Result rough =
        mud_run("cup?n=40", {"layer.spacing=0.3", std::string("post.roughness=") + amplitude});
    const SurfaceMesh cup = make_shape("cup?n=40");
    const TriangleMesh& mesh = rough.state().mesh();
    EXPECT_EQ(validate(mesh), std::vector<std::string>());
    const double area = TriangleMesh(cup.positions, cup.triangles).total_area();
    EXPECT_NEAR(mesh.total_area() / area, 1, 1e-9);
    EXPECT_EQ(rough.report().cracks.fragments, smooth.report().cracks.fragments);
    EXPECT_EQ(rough.report().carried.lost_pieces, 0);
    EXPECT_EQ(node_counts(rough), node_counts(smooth)) << amplitude;
  }
}

TEST(Roughness, GoesIntoTheSimulationsMeshWhereThatIsTheOutput) {
  const Result rough = mud_run("cup?n=24", {"layer.spacing=0.3", "mesh.output=simulation",
                                            "post.roughness=0.01", "post.roughness_step=0.002"});
  const SurfaceMesh& grown = *rough.state().surface;
  const double area = TriangleMesh(grown.positions, grown.triangles).total_area();
  EXPECT_NEAR(rough.state().mesh().total_area() / area, 1, 1e-9);
  EXPECT_EQ(validate(rough.state().mesh()), std::vector<std::string>());
  EXPECT_GT(rough.state().network.edges.size(),
            4 * crack_network(*rough.state().simulation).edges.size());
}

TEST(Roughness, IsTheSameOnAnyNumberOfThreadsAndWhateverElseIsDoneAfterwards) {
  const auto points = [](const Result& result) {
    std::vector<double> flat;
    for (const Vec3& p : crack_lines(result).points)
      flat.insert(flat.end(), p.data(), p.data() + 3);
    return flat;
  };
  const std::vector<double> one = points(mud_run(plate, {"post.roughness=0.01"}));
  EXPECT_EQ(points(mud_run(plate, {"post.roughness=0.01"}, 4)), one);
  EXPECT_EQ(points(mud_run(plate, {"post.roughness=0.01", "post.gap=3", "post.wall=0.1"})), one);
  EXPECT_NE(points(mud_run(plate, {"post.roughness=0.01", "seed=99"})), one);
}

TEST(Roughness, OfZeroLeavesTheRunAsItIs) {
  const Result smooth = mud_run(plate, {});
  const Result zero =
      mud_run(plate, {"post.roughness=0", "post.roughness_exponent=0.3", "post.roughness_step=1"});
  EXPECT_EQ(smooth.state().mesh().triangles(), zero.state().mesh().triangles());
  EXPECT_EQ(smooth.state().mesh().positions(), zero.state().mesh().positions());
}

TEST(Roughness, KeepsTheOpeningOfTheCrackThatItWas) {
  const Result smooth = mud_run(plate, {"post.gap_width=0.004"});
  const Result rough = mud_run(plate, {"post.gap_width=0.004", "post.roughness=0.005"});
  const auto mean_width = [](const Result& result) {
    const CrackNetwork& network = result.state().network;
    double sum = 0;
    for (const CrackEdge& e : network.edges) sum += e.width * network.length(e);
    return sum / total_length(network);
  };
  EXPECT_NEAR(mean_width(rough) / mean_width(smooth), 1, 0.03);
  const CrackedSurface& state = rough.state();
  const std::vector<Vec3> u = state.displacements();
  double apart = 0, length = 0;
  for (const CrackEdge& e : state.network.edges) {
    const std::int32_t h = e.side;
    const double l = state.network.length(e);
    length += l;
    apart += l * (u[state.mesh().from(h)] + u[state.mesh().to(h)]).norm() / 2;
  }
  EXPECT_GT(apart / length, mean_width(smooth) / 4);
}

TEST(Roughness, LeavesRoomForTheGapThatTheSmoothCracksHave) {
  const std::vector<std::string> gap = {"layer.spacing=0.25", "post.gap_width=0.02",
                                        "post.wall=0.02", "post.roughness=0.006"};
  const Result rough = mud_run(plate, gap);
  const Opening opening(rough, rough.report().recipe.post, {});
  EXPECT_EQ(opening.warnings(), std::vector<std::string>());
}

TEST(Roughness, HasBoundedWorkWhateverIsAskedFor) {
  const Result rough = mud_run(plate, {"post.roughness=0.01", "post.roughness_step=0.0000000001"});
  EXPECT_LE(rough.state().network.edges.size(), 4 * 262144u);
  ASSERT_FALSE(rough.report().warnings.empty());
  EXPECT_NE(rough.report().warnings.front().find("post.roughness_step"), std::string::npos);
}

TEST(Roughness, HeldBackBetweenCracksIsToldOf) {
  const Result rough = mud_run(plate, {"post.roughness=1000"});
  ASSERT_FALSE(rough.report().warnings.empty());
  EXPECT_NE(rough.report().warnings.front().find("post.roughness"), std::string::npos);
}

TEST(Roughness, KeepsOffWhatIsPaintedZeroOnTheInputsOwnTriangles) {
  SurfaceMesh painted = make_shape(plate);
  Attribute toughness{"tough", 1, {}};
  for (const Vec3& p : painted.positions) toughness.values.push_back(p.x() > 0 ? 1 : 0);
  painted.vertex_attributes.push_back(toughness);
  const auto surface = std::make_shared<const SurfaceMesh>(painted);
  const auto points_in_zeros = [&](const char* key) {
    Recipe recipe = recipe_with({"layer.spacing=0.14", "mesh.edge=keep", "post.roughness=0.03",
                                 std::string(key) + "=tough"},
                                read_preset("mud"));
    const Result result = crack({surface, {}, "painted"}, recipe, {}, {});
    EXPECT_GT(result.state().network.nodes.size(), 100u);
    int count = 0;
    for (const CrackNode& node : result.state().network.nodes) {
      // A face with a corner of 0 is closed.
      const Triangle& t = painted.triangles[static_cast<std::size_t>(node.face)];
      double least = 1;
      for (const std::int32_t v : t) least = std::min(least, toughness.values[v]);
      bool on_edge = false;
      for (int i = 0; i < 3; ++i) {
        const Vec3 &a = painted.positions[t[i]], &b = painted.positions[t[(i + 1) % 3]];
        on_edge = on_edge || std::abs(turn(a, b, node.position)) < 1e-9;
      }
      count += least == 0 && !on_edge ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(points_in_zeros("material.attribute"), 0);
  EXPECT_EQ(points_in_zeros("layer.attribute"), 0);
}

}  // namespace
}  // namespace craze
