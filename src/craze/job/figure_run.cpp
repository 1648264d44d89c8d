#include "craze/job/figure_run.h"

#include <cmath>
#include <filesystem>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/job/run.h"
#include "craze/job/snapping_diagram.h"

namespace craze {

namespace {

namespace fs = std::filesystem;

constexpr int frame_count = 6;

/// The user's mesh where it is there, else the shape.
std::string input_of(const Figure& figure, const std::string& meshes) {
  if (!figure.mesh.empty() && !meshes.empty()) {
    const fs::path file = fs::path(meshes) / figure.mesh;
    if (fs::exists(file)) return file.string();
  }
  return std::string(figure.shape);
}

std::string quoted(const std::string& word) {
  return word.find_first_of("?&= ") == std::string::npos ? word : "'" + word + "'";
}

struct Size {
  int width, height;
};

Size picture_size(const Figure& figure, int longer) {
  const double a = figure.aspect;
  return a > 1 ? Size{static_cast<int>(std::lround(longer / a)), longer}
               : Size{longer, static_cast<int>(std::lround(longer * a))};
}

std::string command_of(const Figure& figure, const std::string& recipe, const std::string& input,
                       const FigureRequest& request, const std::string& picture) {
  const std::string shown =
      input == figure.shape ? quoted(input) : fmt::format("MESHES/{}", figure.mesh);
  std::string command =
      fmt::format("craze crack {} --recipe recipes/figures/{}.toml", shown, recipe);
  for (const std::string& setting : request.settings) command += " --set " + quoted(setting);
  const Size size = picture_size(figure, request.size);
  command += fmt::format(" --width {} --height {} --azimuth {:g} --elevation {:g}", size.width,
                         size.height, figure.azimuth, figure.elevation);
  return command + (figure.kind == FigureKind::frames
                        ? fmt::format(" --frames {} --frame-count {}", picture, frame_count)
                        : " --picture " + picture);
}

double run_seconds(const RunTimes& time) {
  return time.load + time.prepare + time.relax + time.separation + time.crack;
}

/// Cracks the figure's mesh by one of its recipes.
FigurePart make_part(const Figure& figure, std::string_view recipe, const FigureRequest& request,
                     const Context& context, bool& cancelled) {
  RunRequest run_request;
  run_request.input = input_of(figure, request.meshes);
  run_request.recipe =
      read_recipe(find_figure_recipe(recipe).text, fmt::format("recipes/figures/{}.toml", recipe));
  for (const std::string& setting : request.settings) apply_set(run_request.recipe, setting);
  const Size size = picture_size(figure, request.size);
  run_request.shot.width = size.width;
  run_request.shot.height = size.height;
  run_request.shot.view.azimuth = figure.azimuth;
  run_request.shot.view.elevation = figure.elevation;

  const std::string name(figure.recipes.size() > 1 ? recipe : figure.name);
  const fs::path folder(request.folder);
  run_request.report = (folder / (name + ".json")).string();
  FigurePart part;
  part.name = name;
  std::string made = name;
  if (figure.kind == FigureKind::frames) {
    run_request.frames = (folder / name).string();
    run_request.frame_count = frame_count;
    for (int i = 0; i < frame_count; ++i) {
      part.pictures.push_back(fmt::format("{}/frame_{:04}.png", name, i));
    }
  } else {
    made += ".png";
    run_request.picture = (folder / made).string();
    part.pictures = {made};
  }
  const RunResult result = run(run_request, context);
  cancelled = result.cancelled;
  part.command = command_of(figure, std::string(recipe), run_request.input, request, made);
  part.triangles = result.report.simulation.triangles;
  part.seconds = run_seconds(result.report.time);
  for (const std::string& warning : result.report.warnings) {
    part.warnings.push_back(fmt::format("{}: {}", name, warning));
  }
  return part;
}

std::string stand_in_note(const FigureResult& result) {
  if (!result.stands_in) return "";
  return fmt::format(" The shape `{}` stands in for {}, which may not be shipped.",
                     result.figure->shape, result.figure->mesh);
}

}  // namespace

FigureResult make_figure(const Figure& figure, const FigureRequest& request,
                         const Context& context) {
  std::error_code failure;
  fs::create_directories(request.folder, failure);
  if (failure) {
    throw Error(ErrorKind::output, "cannot make the folder", request.folder, failure.message());
  }
  FigureResult result{&figure, false, {}, false};
  if (figure.kind == FigureKind::diagram) {
    const std::string file = fmt::format("{}.svg", figure.name);
    write_file(fs::path(request.folder) / file, snapping_diagram(), "cannot write the diagram");
    result.parts.push_back({std::string(figure.name),
                            {file},
                            fmt::format("craze figures {} -o .", figure.name),
                            0,
                            0,
                            {}});
    return result;
  }
  result.stands_in = !figure.mesh.empty() && input_of(figure, request.meshes) == figure.shape;
  for (const std::string_view recipe : figure.recipes) {
    result.parts.push_back(make_part(figure, recipe, request, context, result.cancelled));
    if (result.cancelled) break;
  }
  return result;
}

std::string figure_page(const std::vector<FigureResult>& results) {
  std::string table =
      "| figure | triangles here | in the paper | seconds here | in the paper | command |\n"
      "|---|---|---|---|---|---|\n";
  std::string pictures;
  for (const FigureResult& result : results) {
    const Figure& figure = *result.figure;
    pictures += fmt::format("\n## Fig. {}: {}\n{}.{}\n\n", figure.number, figure.name, figure.title,
                            stand_in_note(result));
    for (const FigurePart& part : result.parts) {
      const bool simulated = part.triangles > 0;
      table += fmt::format(
          "| {} {} | {} | {} | {} | {} | `{}` |\n", figure.number, part.name,
          simulated ? fmt::format("{}", part.triangles) : "",
          figure.paper_triangles > 0 ? fmt::format("{}", figure.paper_triangles) : "",
          simulated ? fmt::format("{:.1f}", part.seconds) : "", figure.paper_time, part.command);
      for (const std::string& file : part.pictures) {
        pictures += fmt::format("![{}]({})\n", part.name, file);
      }
    }
  }
  return table + pictures;
}

}  // namespace craze
