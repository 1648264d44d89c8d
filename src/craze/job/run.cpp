#include "craze/job/run.h"

#include <chrono>
#include <memory>

#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/job/load_surface.h"
#include "craze/job/maps/made_uvs.h"
#include "craze/job/maps/scene_uvs.h"
#include "craze/job/material_looks.h"
#include "craze/job/outputs.h"
#include "craze/model/simulation.h"
#include "craze/output/named_nodes.h"
#include "craze/products/report_json.h"
#include "craze/recipe/own_lengths.h"
#include "craze/render/light/environment_file.h"

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

/// What was read, and what goes past the engine.
struct Loaded {
  Input input;
  std::vector<std::string> warnings;
  BesideSurface beside;
};

Loaded load(const RunRequest& request, const Context& context) {
  Loaded loaded;
  Input& input = loaded.input;
  MeshFile file = load_surface(request.input, context);
  loaded.warnings = std::move(file.warnings);
  if (takes_pictures(request) && !request.plain) {
    // Of a mesh that is not made of the input's triangles the first set alone is known.
    const bool all = request.recipe.mesh.output == OutputMesh::asset;
    loaded.beside.looks = material_looks(file.looks, request.input, loaded.warnings, context,
                                         all ? ShownUvs::all : ShownUvs::first);
    if (all && !loaded.beside.looks.empty()) {
      loaded.beside.further_uvs = further_uvs(file, loaded.warnings);
    }
  }
  if (takes_pictures(request) && !request.environment.empty()) {
    loaded.beside.environment = render::read_environment(request.environment, context);
  }
  loaded.beside.source = {request.input, std::move(file.looks), std::move(file.scene)};
  input.name = request.input;
  input.surface = std::make_shared<const SurfaceMesh>(std::move(file.mesh));
  input.textures = load_textures(request.recipe, request.textures, context);
  return loaded;
}

/// What is written after a run that was stopped is written whole; a second signal kills. Progress
/// goes on saying what the run has come to.
Context for_writing(const Context& context, const Report& report, bool stopped) {
  Context writing = context;
  if (stopped) writing.cancelled = nullptr;
  writing.progress = [&context, &report](Progress p) {
    p.cracks = report.cracks.events;
    p.load = report.load;
    if (p.triangles == 0) p.triangles = report.output.triangles;
    context.report(p);
  };
  return writing;
}

}  // namespace

RunResult run(const RunRequest& request, const Context& context) {
  check_request(request);
  Stopwatch total, phase;
  Loaded loaded = load(request, context);
  const bool maps = !request.maps.folder.empty();
  // What is kept as it was can be given UVs, but what is remeshed has those that it came with.
  const auto* document = dynamic_cast<const GltfDocument*>(loaded.beside.source.scene.get());
  if (document && (maps || request.as_maps) &&
      request.recipe.mesh.output == OutputMesh::simulation) {
    check_first_uvs(*document);
  }
  // Before the run, not after it.
  const SurfaceMesh& surface = *loaded.input.surface;
  own_length(request.line_width, {1, metres_per_unit(surface, request.recipe)}, "--line-width");
  const double load_time = phase.lap();

  const Recipe recipe =
      with_named_nodes(request.recipe, *loaded.input.surface, loaded.beside.source.scene.get());
  Result result = crack(std::move(loaded.input), recipe, {request.max_cracks}, context);
  const bool stopped = result.report().stop_reason == to_string(StopReason::cancelled);
  Report report = result.report();
  report.time.load += load_time;
  report.warnings.insert(report.warnings.begin(), loaded.warnings.begin(), loaded.warnings.end());
  phase.lap();

  const Context writing = for_writing(context, report, stopped);
  if (maps && !document && result.state().surface->corner_uvs.empty()) {
    std::string told;
    result = with_made_uvs(result, told, writing);
    report.warnings.push_back(told +
                              (request.output.empty() ? "; -o writes the mesh with them" : ""));
  }
  writing.report({"write"});
  const auto statistics = write_outputs(request, result, loaded.beside, report, writing);
  writing.check();
  report.time.write = phase.lap();
  report.time.total = total.lap();
  RunResult done{report, report_text(report, statistics ? &*statistics : nullptr) + "\n", stopped};
  if (!request.report.empty() && request.report != "-") {
    write_file(request.report, done.report_text, "cannot write the report", writing);
  }
  return done;
}

}  // namespace craze
