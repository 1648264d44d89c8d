// The fast engine against solving the whole mesh directly after every crack.
#include "craze/model/relaxation/equilibrium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "craze/mesh/bounding_diagonal.h"
#include "craze/model/crack_network.h"
#include "craze/model/failure/failure_criterion.h"
#include "craze/model/screening.h"
#include "model/direct_solve.h"
#include "model/runs.h"

namespace craze {
namespace {

SimulationParameters layer() {
  SimulationParameters p;
  p.engine = Engine::quasistatic;
  p.material.criterion = Criterion::strength;
  p.material.strength = 1;
  p.material.relative_toughness = 0.3;
  p.layer.screening_length = 0.15;
  p.evolution.max_load = 2;
  p.crack = {20, 60, NearVertex::slide, 0.25};
  return p;
}

/// v⁺ over the strength that it has to reach, at load 1.
double tension_over_strength(const TriangleMesh& mesh, const StressField& field, std::int32_t v) {
  const Eigenpair pair = largest_eigenpair(separation_tensor(mesh, field, v).tensor);
  return std::max(0.0, pair.value) / node_width(mesh, v, pair.vector);
}

TEST(Equilibrium, AtEveryCrackDecisionTheResidualIsWithinWhatIsStated) {
  Random random(7);
  for (const char* shape : {"plate?n=30&jitter=0.3", "sphere?n=30", "cup?n=30"}) {
    SimulationParameters p = layer();
    const double diagonal = bounding_diagonal(test::mesh_of(shape).positions());
    p.layer.screening_length = 0.08 * diagonal;
    for (int state = 0; state < 4; ++state) {
      p.evolution.max_cracks = 1 + static_cast<std::int64_t>(random.uniform(0, 150));
      Simulation s = test::simulation_of(shape, p, 10 + state);
      s.run({});
      const TriangleMesh& mesh = s.mesh();
      const Eigen::VectorXd residual =
          test::tangential_residual(mesh, s.field(), adhesion(p.layer));
      StressField exact = s.field();
      test::solve_directly(exact, mesh, adhesion(p.layer));
      std::vector<double> widths;
      for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (mesh.is_open_vertex(v)) continue;
        const Eigenpair pair = largest_eigenpair(separation_tensor(mesh, exact, v).tensor);
        const double width = node_width(mesh, v, pair.vector);
        widths.push_back(width);
        // The tension that decides whether v fails, against that of the exact equilibrium.
        EXPECT_NEAR(s.load() * tension_over_strength(mesh, s.field(), v),
                    s.load() * tension_over_strength(mesh, exact, v), 0.15)
            << shape << " after " << s.events();
      }
      std::nth_element(widths.begin(), widths.begin() + widths.size() / 2, widths.end());
      const double failure_force = widths[widths.size() / 2] / s.load();
      for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_LT(residual.segment<2>(2 * v).norm(), 1.2 * p.evolution.residual * failure_force)
            << shape << " after " << s.events();
      }
    }
  }
}

TriangleMesh scaled(const std::string& shape, double by) {
  const TriangleMesh mesh = test::mesh_of(shape);
  std::vector<Vec3> positions = mesh.positions();
  for (Vec3& p : positions) p *= by;
  return {positions, mesh.triangles()};
}

TEST(Equilibrium, PatternsDoNotDependOnTheUnitOfLength) {
  // Powers of two round nothing: the same bits, but for the unit.
  std::vector<Vec3> reference;
  for (const double unit : {1.0, 0x1p90, 0x1p-90}) {
    SimulationParameters p = layer();
    p.layer.screening_length = 0.15 * unit;
    const TriangleMesh mesh = scaled("plate?n=20&jitter=0.3", unit);
    Simulation s(mesh, test::noisy_tension(mesh, 1), p, {});
    s.run({});
    EXPECT_GT(s.events(), 20);
    std::vector<Vec3> positions = s.mesh().positions();
    for (Vec3& position : positions) position /= unit;
    if (reference.empty()) reference = positions;
    EXPECT_EQ(positions, reference) << unit;
  }
}

// A toughness in forces that are nothing beside those of a huge mesh asks for a residual below
// what doubles tell.
TEST(Equilibrium, AToleranceBelowTheRoundingOfForcesEnds) {
  SimulationParameters p = layer();
  p.material = {};
  p.layer.screening_length = 0.3e20;
  p.evolution.max_cracks = 5;
  const TriangleMesh mesh = scaled("plate?n=20&jitter=0.3", 1e20);
  Simulation s(mesh, test::noisy_tension(mesh, 1), p, {});
  s.run({});
  EXPECT_EQ(s.events(), 5);
}

TEST(Equilibrium, TellsWhetherTheToleranceWasMet) {
  for (const double residual : {0.05, 1e-6, 1e-16}) {
    SimulationParameters p = layer();
    p.evolution.residual = residual;
    p.evolution.max_cracks = 5;
    Simulation s = test::simulation_of("plate?n=20&jitter=0.3", p);
    s.run({});
    EXPECT_EQ(s.events(), 5);
    EXPECT_EQ(s.met_tolerance(), residual > 1e-12) << residual;
  }
}

/// Where cracks open, one after the other, when the whole mesh is solved directly and every node
/// looked at after every single crack.
std::vector<Vec3> exhaustive_sequence(const TriangleMesh& start, const SimulationFields& fields,
                                      const SimulationParameters& p, int events) {
  CrackedSheet sheet =
      test::sheet_of(start, fields.stress, engine_singular_value_cap(start, Engine::quasistatic));
  const TriangleMesh& mesh = sheet.mesh();
  StressField& field = sheet.field();
  FailureCriterion criterion(p.material, process_zone(p.material, p.layer));
  const CrackRules rules{p.crack.snap_angle * std::numbers::pi / 180,
                         p.crack.back_angle * std::numbers::pi / 180, p.crack.near_vertex};
  std::vector<Vec3> sequence;
  std::vector<char> arrested(mesh.vertex_count(), 0);
  CrackOutcome outcome;
  std::int32_t label = 0;
  while (static_cast<int>(sequence.size()) < events) {
    test::solve_directly(field, mesh, adhesion(p.layer));
    double best = 0;
    std::int32_t next = -1;
    Vec3 normal = Vec3::Zero();
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (arrested[v]) continue;
      const Eigenpair pair = largest_eigenpair(separation_tensor(mesh, field, v).tensor);
      if (!(pair.value > 0)) continue;
      std::int32_t shield = -1;
      const double least = criterion.least_threshold(mesh, v, pair.vector, 1);
      const double measure =
          pair.value / criterion.threshold(mesh, field, v, pair, 1, least, shield);
      if (measure <= best) continue;
      best = measure;
      next = v;
      normal = pair.vector;
    }
    if (next < 0) break;
    open_crack(sheet, next, normal, rules, label, outcome);
    arrested.resize(mesh.vertex_count(), 0);
    if (outcome.empty()) {
      arrested[next] = 1;
      continue;
    }
    label += static_cast<std::int32_t>(outcome.segments.size());
    for (const std::int32_t tip : outcome.tips) criterion.tip_advanced(mesh, next, tip);
    for (const std::int32_t v : outcome.changed_nodes) {
      criterion.node_changed(mesh, v);
      arrested[v] = 0;
    }
    sequence.push_back(mesh.position(outcome.segments.front().from_root));
  }
  return sequence;
}

TEST(Equilibrium, CracksFollowEachOtherAsWhenEverythingIsSolvedAfterEachOne) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SimulationParameters p = layer();
    p.material.alpha = 0;
    p.crack.stride = 0;
    p.evolution.load_step = 0;
    p.evolution.residual = 1e-5;
    p.evolution.max_load = 4;
    constexpr int events = 40;
    p.evolution.max_cracks = events;
    p.layer.screening_length = 0.2;
    const TriangleMesh mesh = test::mesh_of("plate?n=14&jitter=0.3");
    const SimulationFields fields = test::noisy_tension(mesh, seed);
    SimulationParameters resolved = resolve_lengths(p, bounding_diagonal(mesh.positions()));
    Simulation s(mesh, fields, p, {});
    s.run({});
    const std::vector<Vec3> expected = exhaustive_sequence(mesh, fields, resolved, events);
    ASSERT_EQ(s.events(), static_cast<std::int64_t>(expected.size()));
    const CrackNetwork network = crack_network(s);
    std::int32_t event = 0;
    for (const CrackEdge& edge : network.edges) {
      if (edge.event != event) continue;
      const Vec3 where = network.nodes[edge.a].position - expected[event];
      // Cracks start at the same node, give or take how far the field lets it slide: the mesh has
      // edges of 1 / 14.
      ASSERT_LT(where.norm(), 1e-3 / 14) << "seed " << seed << " event " << event;
      ++event;
    }
    EXPECT_EQ(event, events);
  }
}

}  // namespace
}  // namespace craze
