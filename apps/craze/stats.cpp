// craze stats MESH_OR_LINES: the numbers that describe a crack pattern.
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/job/graph_from_file.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/products/statistics/graph/graph_input.h"
#include "craze/products/statistics/graph/simplify_lines.h"
#include "craze/products/statistics/plots/plots.h"
#include "craze/products/statistics/statistics_report.h"
#include "craze/recipe/own_lengths.h"
#include "run_options.h"

namespace craze::app {

namespace {

void write_plots(const std::filesystem::path& folder, const CrackGraphInput& graph,
                 const Statistics& statistics) {
  std::error_code failed_to_create;
  std::filesystem::create_directories(folder, failed_to_create);
  if (failed_to_create) {
    throw Error(ErrorKind::output, "cannot write plots", folder.string(),
                failed_to_create.message());
  }
  const auto write = [&](const char* name, const std::string& svg) {
    write_file(folder / name, svg, "cannot write plots");
  };
  write("angles.svg", angles_svg(statistics));
  write("areas.svg", areas_svg(statistics));
  write("sides.svg", sides_svg(statistics));
  write("times.svg", graph_svg(graph, GraphColor::time));
  write("junctions.svg", graph_svg(graph, GraphColor::junction));
}

}  // namespace

void add_stats(CLI::App& app, Action& action) {
  struct Options {
    std::string input, plots;
    Length simplify = 0;
    bool json = false, no_warnings = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb =
      app.add_subcommand("stats", "Measure a crack pattern, beside patterns without mechanics");
  verb->add_option("MESH_OR_LINES", options->input,
                   "A cracked mesh, lines (.ply .obj .json), or null:NAME?cells=N&seed=S")
      ->required()
      ->type_name("");
  verb->add_flag("--json", options->json, "As JSON");
  add_length(*verb, "--simplify", options->simplify,
             "Draw lines by as few of their points as stay within this of them, in the unit of the "
             "input, a pixel for a skeleton, or with a unit");
  verb->add_option("--plots", options->plots,
                   "Write histograms and pictures of the graph into this folder, as SVG")
      ->type_name("DIR");
  add_warning_option(*verb, options->no_warnings);
  verb->footer(
      "Examples:\n"
      "  craze stats cracked.ply\n"
      "  craze stats skeleton.json --simplify 1 --json | jq .angles.t\n"
      "  craze stats null:voronoi?cells=500 --plots plots");
  verb->callback([options, &action] {
    action = [options] {
      std::vector<std::string> warnings;
      CrackGraphInput graph = graph_from_file(options->input, warnings);
      if (!options->no_warnings) print_warnings({}, warnings);
      const Yardstick yardstick{bounding_diagonal(graph.points), graph.metres_per_unit};
      simplify_lines(graph, own_length(options->simplify, yardstick, "--simplify"));
      const StatisticsWithSensitivity statistics = compute_with_sensitivity(graph);
      if (!options->plots.empty()) write_plots(options->plots, graph, statistics.result);
      const std::vector<NullRow> nulls = null_rows({});
      if (options->json) return print(to_json(statistics, nulls).dump(2) + "\n");
      return print(to_text(statistics, nulls));
    };
  });
}

}  // namespace craze::app
