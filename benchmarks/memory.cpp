// What the memory gives: the figure beside which the relaxation is to be read.
#include <benchmark/benchmark.h>

#include <cstring>
#include <vector>

#include "craze/base/parallel.h"

namespace craze {
namespace {

// Copies `MiB` at a time; bytes read and bytes written both count.
void memory_copy(benchmark::State& state) {
  const Threads threads(static_cast<int>(state.range(0)));
  const auto bytes = static_cast<std::size_t>(state.range(1)) << 20;
  std::vector<char> from(bytes, 1), to(bytes, 2);
  for (auto _ : state) {
    parallel_for(threads, bytes, bytes / 8, [&](std::size_t b, std::size_t e) {
      std::memcpy(to.data() + b, from.data() + b, e - b);
    });
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * 2 * bytes));
}

// 2 MiB: what a plate of n = 99 takes; 256 MiB: far beyond any cache.
BENCHMARK(memory_copy)
    ->ArgNames({"threads", "MiB"})
    ->ArgsProduct({{1, 0}, {2, 256}})
    ->UseRealTime();

}  // namespace
}  // namespace craze
