// What the rest of the loop costs: failure criteria, cuts, whole runs.
#include <benchmark/benchmark.h>

#include "craze/base/symmetric_eigen.h"
#include "craze/model/crack_insertion.h"
#include "craze/model/separation_tensor.h"
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
    TriangleMesh mesh = plate;
    StressField field = uncut;
    Random random(2);
    CrackOutcome outcome;
    state.ResumeTiming();
    for (int i = 0; i < 2000; ++i) {
      const auto v = static_cast<std::int32_t>(random.below(mesh.vertex_count()));
      const double angle = random.uniform(0, 6.3);
      open_crack(mesh, field, v, {std::cos(angle), std::sin(angle), 0}, {0.436, 0.262}, 0, outcome);
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

}  // namespace
}  // namespace craze
