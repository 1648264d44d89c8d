// craze stats MESH_OR_LINES: the numbers of a crack pattern, simulated or traced from a photograph.
#include <memory>
#include <nlohmann/json.hpp>

#include "app.h"
#include "craze/io/read_lines.h"
#include "craze/io/read_mesh.h"
#include "craze/stats/graph_input.h"
#include "craze/stats/statistics_report.h"

namespace craze::app {

namespace {

CrackGraphInput read_graph(const std::string& path) {
  if (const auto lines = read_lines(path)) return graph_from_lines(*lines);
  return graph_from_cut_mesh(read_mesh(path));
}

}  // namespace

void add_stats(CLI::App& app, Action& action) {
  struct Options {
    std::string input;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("stats", "Measure a crack pattern");
  verb->add_option("MESH_OR_LINES", options->input, "A cracked mesh, or lines: .ply .obj .json")
      ->required()
      ->type_name("");
  verb->add_flag("--json", options->json, "As JSON");
  verb->footer(
      "Examples:\n"
      "  craze stats mud.ply\n"
      "  craze stats traced.obj --json");
  verb->callback([options, &action] {
    action = [options] {
      const StatisticsOptions settings;
      const auto statistics = compute_with_sensitivity(read_graph(options->input), settings);
      const std::vector<NullRow> nulls = null_rows(settings);
      if (!options->json) return print(to_text(statistics, nulls));
      return print(to_json(statistics, nulls).dump(2) + "\n");
    };
  });
}

}  // namespace craze::app
