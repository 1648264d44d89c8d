// Cracks shapes by every preset and prints a hash of what comes out, a line for each; the same
// program is built for WebAssembly and for the machine. cracked_presets [SHAPE]...
// Seconds go to stderr.
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "craze/base/random.h"
#include "craze/engine.h"
#include "craze/presets.h"
#include "craze/products.h"
#include "craze/shapes.h"

namespace {

// The presets' spacing times this: what is compared are bits, and a quarter of the triangles has
// all kinds of them.
constexpr double coarser = 2;

// Of every bit of the numbers, in their order.
class Hash {
 public:
  template <class Number>
  void add(const std::vector<Number>& numbers) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
    for (std::size_t i = 0; i < numbers.size() * sizeof(Number); ++i) {
      value_ = craze::hash_bits(value_ ^ bytes[i]);
    }
  }
  void add(const craze::SurfaceMesh& mesh) {
    add(mesh.positions);
    add(mesh.triangles);
    add(mesh.corner_uvs);
    for (const craze::Attribute& a : mesh.vertex_attributes) add(a.values);
    for (const craze::Attribute& a : mesh.face_attributes) add(a.values);
  }
  unsigned long long value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

void crack_and_print(const std::string& shape, const craze::Preset& preset) {
  using Clock = std::chrono::steady_clock;
  craze::Context context;
  context.threads = 1;
  const std::string name(preset.name);
  craze::Recipe recipe = craze::read_preset(name);
  recipe.simulation.layer.relative_spacing *= coarser;
  const auto surface = std::make_shared<const craze::SurfaceMesh>(craze::make_shape(shape));

  const Clock::time_point begin = Clock::now();
  const craze::Result result = craze::crack({surface, {}, shape}, recipe, {}, context);
  const std::chrono::duration<double> took = Clock::now() - begin;

  const craze::SurfaceMesh cut = craze::cut_mesh(result, context);
  const craze::Opening opening(result, result.report().recipe.post, context);
  Hash cut_hash, opened_hash;
  cut_hash.add(cut);
  opened_hash.add(opening.mesh());
  std::printf("%s %s: %zu triangles, %lld cracks, cut %016llx, opened %016llx\n", shape.c_str(),
              name.c_str(), cut.triangles.size(),
              static_cast<long long>(result.report().cracks.events), cut_hash.value(),
              opened_hash.value());
  std::fprintf(stderr, "%s %s: %.3f s\n", shape.c_str(), name.c_str(), took.count());
}

}  // namespace

int main(int argc, char** argv) try {
  std::vector<std::string> shapes(argv + 1, argv + argc);
  if (shapes.empty()) shapes = {"plate?n=30&jitter=0.3", "cup?n=48"};
  for (const std::string& shape : shapes) {
    for (const craze::Preset& preset : craze::presets()) crack_and_print(shape, preset);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
