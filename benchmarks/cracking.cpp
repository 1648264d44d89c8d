// What the rest of the loop costs: failure criteria, cuts, whole runs.
#include <benchmark/benchmark.h>

#include "craze/base/symmetric_eigen.h"
#include "craze/model/crack_network.h"
#include "craze/model/cutting/crack_insertion.h"
#include "craze/model/failure/separation_tensor.h"
#include "craze/model/simulation.h"
#include "states.h"

namespace craze {
namespace {

void separation_tensors(benchmark::State& state) {
  const TriangleMesh mesh = bench::plate(99);
  const StressField field = bench::noisy_field(mesh, 0.01 * static_cast<double>(state.range(0)));
  for (auto _ : state) {
    double sum = 0;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      sum += separation_tensor(mesh, field, v).bound;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * mesh.vertex_count());
}
BENCHMARK(separation_tensors)
    ->ArgName("noise_percent")
    ->Arg(5)
    ->Arg(100)
    ->Unit(benchmark::kMicrosecond);

void separation_tensors_with_eigenpair(benchmark::State& state) {
  const TriangleMesh mesh = bench::plate(99);
  const StressField field = bench::noisy_field(mesh, 0.01 * static_cast<double>(state.range(0)));
  for (auto _ : state) {
    double sum = 0;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      sum += largest_eigenpair(separation_tensor(mesh, field, v).tensor).value;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * mesh.vertex_count());
}
BENCHMARK(separation_tensors_with_eigenpair)
    ->ArgName("noise_percent")
    ->Arg(5)
    ->Arg(100)
    ->Unit(benchmark::kMicrosecond);

// Cracks at random nodes of a fresh plate; items are cut edges.
void cuts(benchmark::State& state) {
  const TriangleMesh plate = bench::plate(99);
  const StressField uncut = bench::noisy_field(plate, 0.05);
  std::int64_t segments = 0;
  for (auto _ : state) {
    state.PauseTiming();
    CrackedSheet sheet(plate, uncut);
    Random random(2);
    CrackOutcome outcome;
    state.ResumeTiming();
    for (int i = 0; i < 2000; ++i) {
      const auto v = static_cast<std::int32_t>(random.below(sheet.mesh().vertex_count()));
      const double angle = random.uniform(0, 6.3);
      open_crack(sheet, v, {std::cos(angle), std::sin(angle), 0}, {0.436, 0.262}, 0, outcome);
      segments += static_cast<std::int64_t>(outcome.segments.size());
    }
  }
  state.SetItemsProcessed(segments);
}
BENCHMARK(cuts)->Unit(benchmark::kMicrosecond);

// The paper's loop on a plate of 5,000 triangles until 200 nodes have failed.
void euler_run(benchmark::State& state) {
  const TriangleMesh mesh = bench::plate(50);
  Random random(3);
  SimulationFields fields;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const double c = 1 + 0.05 * random.normal();
    fields.stress.push_back({c, c, 0, 0, 0, 0});
  }
  SimulationParameters parameters;
  parameters.material.toughness = 0.01;
  parameters.layer.screening_length = 0.1;
  parameters.evolution.relaxation_steps = 5;
  parameters.evolution.max_cracks = 200;
  Context context;
  context.threads = static_cast<int>(state.range(0));
  for (auto _ : state) {
    Simulation simulation(mesh, fields, parameters, context);
    simulation.run(context);
    benchmark::DoNotOptimize(simulation.events());
  }
  state.SetItemsProcessed(state.iterations() * parameters.evolution.max_cracks);
}
BENCHMARK(euler_run)->ArgName("threads")->Arg(1)->Arg(0)->UseRealTime()->Unit(
    benchmark::kMillisecond);

// A closed surface without adhesion until 60 nodes have failed: the paper's steps (0) against the
// same flow in fewer (1), R steps to an event.
void flow_run(benchmark::State& state) {
  const TriangleMesh mesh = bench::mesh_of("sphere?n=32");
  Random random(4);
  SimulationFields fields;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const double c = 1 + 0.05 * random.normal();
    fields.stress.push_back(to_world(Sym2::isotropic(c), tangent_frame(mesh, f)));
  }
  SimulationParameters parameters;
  parameters.engine = state.range(0) == 0 ? Engine::euler : Engine::quasistatic;
  parameters.material.toughness = 0.01;
  parameters.evolution.relaxation_steps = state.range(1);
  parameters.evolution.max_cracks = 60;
  Context context;
  context.threads = 1;
  double length = 0;
  for (auto _ : state) {
    Simulation simulation(mesh, fields, parameters, context);
    simulation.run(context);
    length = 0;
    const CrackNetwork network = crack_network(simulation);
    for (const CrackEdge& e : network.edges) {
      length += (network.nodes[e.a].position - network.nodes[e.b].position).norm();
    }
  }
  state.counters["crack_length"] = length;
}
BENCHMARK(flow_run)
    ->ArgNames({"accelerated", "R"})
    ->ArgsProduct({{0, 1}, {10, 50, 200, 1000}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace craze
