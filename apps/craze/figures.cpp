// craze figures [NAME]...: the figures of the paper.

#include <filesystem>
#include <memory>

#include "app.h"
#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/job/figure_run.h"
#include "craze/render/picture.h"
#include "run_options.h"
#include "terminal/interrupt.h"

namespace craze::app {

namespace {

struct FiguresArguments {
  FigureRequest request;
  std::vector<std::string> names;
  RunOptions run;
};

int make_figures(const FiguresArguments& options) {
  std::vector<const Figure*> wanted;
  for (const std::string& name : options.names) wanted.push_back(&find_figure(name));
  if (wanted.empty()) {
    for (const Figure& figure : figure_table()) wanted.push_back(&figure);
  }
  const std::string& meshes = options.request.meshes;
  if (!meshes.empty() && !std::filesystem::is_directory(meshes)) {
    throw Error(ErrorKind::input, "cannot read the meshes", meshes, "there is no such folder");
  }
  std::vector<FigureResult> results;
  for (const Figure* figure : wanted) {
    results.push_back(make_figure(*figure, options.request, Run(options.run).context()));
    for (const FigurePart& part : results.back().parts) print_warnings(options.run, part.warnings);
    if (results.back().cancelled) return interrupt_code();
  }
  const std::string page = figure_page(results);
  write_file(std::filesystem::path(options.request.folder) / "figures.md", page);
  return options.run.quiet ? done : print(page);
}

std::string figure_list() {
  std::string list = "Figures (number, name, what it shows, the mesh it looks for):\n";
  for (const Figure& f : figure_table()) {
    list += fmt::format("  {:>2} {:<12} {}{}\n", f.number, f.name, f.title,
                        f.mesh.empty() ? "" : fmt::format(" ({})", f.mesh));
  }
  return list;
}

}  // namespace

void add_figures(CLI::App& app, Action& action) {
  const auto options = std::make_shared<FiguresArguments>();
  CLI::App* verb = app.add_subcommand("figures", "Make the figures of the paper");
  verb->add_option("NAME", options->names, "Names or numbers; all where none is given")
      ->type_name("");
  verb->add_option("-o,--output", options->request.folder,
                   "Where pictures, reports and figures.md, the table of all, go")
      ->required()
      ->type_name("DIR");
  verb->add_option("--meshes", options->request.meshes,
                   "Where your meshes are; a built-in shape stands in for one that is missing")
      ->type_name("DIR");
  verb->add_option("--set", options->request.settings,
                   "Change one key of every recipe, as often as you like")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb->add_option("--size", options->request.size, "Longer side of the pictures, pixels")
      ->type_name("N")
      ->check(CLI::Range(1, render::PictureOptions::largest_size))
      ->capture_default_str();
  add_run_options(*verb, options->run, "No progress, and no table on standard output");
  verb->footer(figure_list() +
               "Examples:\n"
               "  craze figures -o figures --meshes scans\n"
               "  craze figures mud-jagged 5 -o figures --set seed=3");
  verb->callback([options, &action] { action = [options] { return make_figures(*options); }; });
}

}  // namespace craze::app
