// craze sweep PLAN: many runs as one table.
#include "craze/job/sweep/sweep.h"

#include <memory>

#include "app.h"
#include "craze/base/text/format.h"
#include "craze/job/sweep/sweep_rows.h"
#include "growth_note.h"
#include "run_options.h"

namespace craze::app {

namespace {

struct SweepArguments {
  std::string plan, folder, shard = "0/1";
  bool keys = false;
  RunOptions run;
};

int sweep(const SweepArguments& options) {
  if (options.keys) return print(plan_reference(sweep_schema()));
  const Shard shard = parse_shard(options.shard);
  const PlanSource source = read_plan_for(options.folder, options.plan, "sweep");
  print_growth(options.run, sweep_growth(source, options.folder), {"the table", "rows", "part"});
  const Run run(options.run);
  const SweepResult made = run_sweep(source, options.folder, shard, run.context());
  print_warnings(options.run, made.warnings);
  if (options.run.quiet) return done;
  const std::string left = made.parts_left == 0
                               ? "table.csv, columns and plots are whole"
                               : fmt::format("{} parts are left to other shards", made.parts_left);
  return print(fmt::format("{} rows in {} parts, {} made now; {}\n", made.rows, made.parts,
                           made.parts_made, left));
}

}  // namespace

void add_sweep(CLI::App& app, Action& action) {
  const auto options = std::make_shared<SweepArguments>();
  CLI::App* verb = app.add_subcommand("sweep", "Run grids and random designs, as one table");
  CLI::Option* plan = verb->add_option("PLAN", options->plan, "A plan, TOML: docs/sweeps.md");
  plan->type_name("");
  CLI::Option* folder = verb->add_option("-o,--output", options->folder, "Where the table goes");
  folder->type_name("DIR");
  CLI::Option* shard =
      verb->add_option(
              "--shard", options->shard,
              "Do only every N-th part, for one of N processes or machines; all may write to "
              "one folder")
          ->type_name("i/N");
  CLI::Option* keys = verb->add_flag("--keys", options->keys, "List the keys of such plans");
  keys->excludes(plan)->excludes(folder)->excludes(shard);
  add_run_options(*verb, options->run, "No progress, no word at the end");
  verb->footer(
      "Examples:\n"
      "  craze sweep spacing.toml -o spacing\n"
      "  craze sweep spacing.toml -o spacing --shard 3/16\n"
      "  parallel craze sweep spacing.toml -o spacing --threads 1 --shard {}/8 ::: $(seq 8)\n"
      "A run that was stopped, even killed, goes on where it was when started again, with any "
      "number of shards; so does a whole one with more draws, where the plan has no axis.");
  verb->callback([options, plan, folder, &action] {
    if (!options->keys) {
      if (plan->empty()) throw CLI::RequiredError("PLAN");
      if (folder->empty()) throw CLI::RequiredError("--output");
    }
    action = [options] { return sweep(*options); };
  });
}

}  // namespace craze::app
