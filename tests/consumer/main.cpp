// Cracks a small plate through the installed headers: 0 when there are cracks.
#include <craze/base/error.h>
#include <craze/job/run.h>
#include <craze/recipe/presets.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    craze::RunRequest request;
    request.input = "shape:plate?n=20";
    request.recipe = craze::read_preset("mud");
    request.max_cracks = 5;
    request.output = argv[1];
    craze::check_request(request);
    const craze::RunResult result = craze::run(request, {});
    const int events = static_cast<int>(result.report.cracks.events);
    std::printf("%d cracks\n", events);
    return events > 0 ? 0 : 1;
  } catch (const craze::Error& e) {
    std::fprintf(stderr, "consumer: %s\n", e.what());
    return 1;
  }
}
