// Cracks a small plate through the installed headers: 0 when there are cracks.
#include <craze/engine.h>
#include <craze/error.h>
#include <craze/presets.h>
#include <craze/products.h>
#include <craze/shapes.h>
#include <craze/write_mesh.h>

#include <cstdio>
#include <memory>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    auto plate = std::make_shared<const craze::SurfaceMesh>(craze::make_shape("plate?n=20"));
    const craze::Result result =
        craze::crack({plate, {}, "a plate"}, craze::read_preset("mud"), {.max_cracks = 5}, {});
    craze::write_mesh(argv[1], craze::cut_mesh(result, {}));
    std::printf("%d cracks\n", static_cast<int>(result.report().cracks.events));
    return result.report().cracks.events > 0 ? 0 : 1;
  } catch (const craze::Error& e) {
    std::fprintf(stderr, "consumer: %s\n", e.what());
    return 1;
  }
}
