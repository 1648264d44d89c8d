#include "craze/scenario/run.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "craze/base/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/mesh/repair.h"
#include "craze/scenario/load_surface.h"
#include "craze/scenario/outputs.h"
#include "craze/scenario/spacing_rounds.h"

namespace craze {

namespace {

/// Seconds since it was made or last asked.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

int thread_count(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

SurfaceMesh load_and_repair(const RunRequest& request, RunReport& report) {
  const SurfaceMesh input = load_surface(request.input);
  report.input = count_mesh(input);
  SurfaceMesh surface = repair(input, {}, report.repair);
  if (surface.triangles.empty()) {
    throw Error(ErrorKind::input, "nothing to crack", request.input,
                "the mesh has no triangle with area");
  }
  return surface;
}

}  // namespace

RunResult run(const RunRequest& request, const Context& context) {
  check_request(request);
  Stopwatch total, phase;
  RunReport report;
  report.recipe = request.recipe;
  if (request.max_cracks) report.recipe.simulation.evolution.max_cracks = *request.max_cracks;
  report.threads = thread_count(context.threads);

  context.report({"load"});
  SurfaceMesh repaired = load_and_repair(request, report);
  report.time.load = phase.lap();

  context.report({"prepare", -1, 0, static_cast<std::int64_t>(repaired.triangles.size())});
  const SpacedRun cracked = request.max_cracks == 0
                                ? uncracked(std::move(repaired), report.recipe, context)
                                : run_to_spacing(std::move(repaired), report.recipe, context);
  const LastCycle& last = cracked.last;
  const Simulation& simulation = *last.simulation;
  report.recipe = cracked.recipe;
  report.simulation = count_mesh(cracked.surface.mesh);
  report.stop_reason = to_string(last.reason);
  if (last.unstressed) {
    // In equilibrium from the start: not wrong, but seldom what was wanted.
    report.warnings.push_back(
        "nothing can crack (stress): it is zero everywhere; give stress.uniform, an impact or a "
        "painted stress that is not");
  }
  if (!simulation.met_tolerance()) {
    report.warnings.push_back(
        "equilibrium was not always reached (evolution.residual): double precision ends before it; "
        "cracks may open a little too early or late");
  }
  report.load = simulation.load();
  report.time.prepare = cracked.prepare + last.prepare;
  report.time.relax = last.times.relax;
  report.time.separation = last.times.separation;
  report.time.crack = last.times.crack;
  phase.lap();

  context.report({"write", -1, simulation.events(), simulation.mesh().face_count(), report.load});
  write_outputs(request, cracked.surface.mesh, simulation, report, context);
  if (last.reason == StopReason::equilibrium || last.reason == StopReason::max_load) {
    if (const auto warning = spacing_warning(report.recipe.simulation.layer, simulation.mesh(),
                                             report.cracks.fragments)) {
      report.warnings.push_back(*warning);
    }
  }
  report.time.write = phase.lap();
  report.time.total = total.lap();
  RunResult result{report_to_json(report), last.reason == StopReason::cancelled};
  if (!request.report.empty() && request.report != "-") {
    write_file(request.report, result.report.dump(2) + "\n", "cannot write the report");
  }
  return result;
}

}  // namespace craze
