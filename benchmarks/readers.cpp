// Bytes per second through the mesh readers and writers, from files in the system's cache.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "craze/read_mesh.h"
#include "craze/write_mesh.h"
#include "states.h"

namespace craze {
namespace {

const char* const formats[] = {"ply", "obj", "stl", "glb"};

/// A file of 50,000 triangles that lives as long as this does.
class SampleFile {
 public:
  explicit SampleFile(const std::string& format)
      : path_(std::filesystem::temp_directory_path() / ("craze_benchmark." + format)),
        mesh_(make_shape("sphere?n=50")) {
    write_mesh(path_, mesh_);
  }
  ~SampleFile() { std::filesystem::remove(path_); }
  SampleFile(const SampleFile&) = delete;
  SampleFile& operator=(const SampleFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const SurfaceMesh& mesh() const { return mesh_; }
  void count(benchmark::State& state) const {
    state.SetBytesProcessed(state.iterations() *
                            static_cast<std::int64_t>(std::filesystem::file_size(path_)));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh_.triangles.size()));
  }

 private:
  std::filesystem::path path_;
  SurfaceMesh mesh_;
};

void read_file(benchmark::State& state) {
  const std::string format = formats[state.range(0)];
  const SampleFile file(format);
  for (auto _ : state) benchmark::DoNotOptimize(read_mesh_file(file.path()));
  file.count(state);
  state.SetLabel(format);
}
BENCHMARK(read_file)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void write_file(benchmark::State& state) {
  const std::string format = formats[state.range(0)];
  const SampleFile file(format);
  for (auto _ : state) write_mesh(file.path(), file.mesh());
  file.count(state);
  state.SetLabel(format);
}
BENCHMARK(write_file)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace craze
