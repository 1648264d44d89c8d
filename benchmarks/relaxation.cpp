// Triangle updates per second of the explicit relaxation, every element active.
#include "craze/model/relaxation/euler_relaxation.h"

#include <benchmark/benchmark.h>

#include "states.h"

namespace craze {
namespace {

void relaxation(benchmark::State& state) {
  const TriangleMesh mesh = bench::plate(state.range(0));
  StressField field = bench::noisy_field(mesh, 0.05);
  EulerRelaxation euler(mesh, field, {0.01, 1.0, 0});
  constexpr std::int64_t steps = 10;
  const Threads threads(static_cast<int>(state.range(1)));
  for (auto _ : state) euler.run(field, mesh, steps, threads);
  state.counters["triangle_updates"] =
      benchmark::Counter(static_cast<double>(state.iterations() * steps * mesh.face_count()),
                         benchmark::Counter::kIsRate);
}

BENCHMARK(relaxation)
    ->ArgNames({"n", "threads"})
    ->ArgsProduct({{99, 300, 700}, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace craze
