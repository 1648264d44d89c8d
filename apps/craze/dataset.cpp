// craze dataset PLAN, and what can be done with a set: verify, sample, look.
#include "craze/job/dataset/dataset.h"

#include <memory>

#include "app.h"
#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/job/dataset/dataset_growth.h"
#include "craze/job/dataset/shards/contact_sheet.h"
#include "craze/job/dataset/verify_dataset.h"
#include "craze/job/output_folder.h"
#include "craze/job/run.h"
#include "craze/render/png.h"
#include "growth_note.h"
#include "run_options.h"

namespace craze::app {

namespace {

struct DatasetArguments {
  std::string plan, folder, shard = "0/1", sample, output;
  std::uint64_t samples = 0;  ///< 0: as the plan says
  bool keys = false;
  SheetOptions sheet;
  RunOptions run;
};

int make(const DatasetArguments& options) {
  if (options.keys) return print(plan_reference(dataset_schema()));
  const Shard shard = parse_shard(options.shard);
  PlanSource source = read_plan_for(options.output, options.plan, "dataset");
  if (options.samples > 0) source = with_samples(source, options.samples);
  print_growth(options.run, dataset_growth(source, options.output),
               {"the set", "samples", "shard"});
  const Run run(options.run);
  const DatasetResult made = make_dataset(source, options.output, shard, run.context());
  if (options.run.quiet) return done;
  return print(fmt::format(
      "{} samples in {} shards, {} made now; {}\n", made.samples, made.shards, made.shards_made,
      made.shards_left == 0 ? "the set is whole"
                            : fmt::format("{} are left to others", made.shards_left)));
}

int verify(const DatasetArguments& options) {
  const Run run(options.run);
  const std::vector<std::string> faults = verify_dataset(options.folder, run.context());
  std::string text;
  for (const std::string& fault : faults) text += fault + "\n";
  if (!options.run.quiet) {
    text += faults.empty() ? "the set is whole\n"
                           : "remove the files that are not, and make the set again\n";
  }
  const int code = print(text);
  return faults.empty() ? code : failed;
}

int remake(const DatasetArguments& options) {
  const Run run(options.run);
  const RemadeSample remade = remake_sample(options.folder, options.sample, run.context());
  if (!options.output.empty()) {
    make_output_folder("the sample", options.output);
    for (const SampleFile& file : remade.sample.files) {
      write_file(std::filesystem::path(options.output) / (remade.sample.id + "." + file.kind),
                 file.bytes, "cannot write the sample", run.context());
    }
  }
  std::string text;
  for (const std::string& kind : remade.differing) {
    text += remade.sample.id + "." + kind + " is not what the set holds\n";
  }
  if (remade.differing.empty() && !options.run.quiet) {
    text = fmt::format("sample {}: {} files, the same bytes as in the set\n", remade.sample.id,
                       remade.sample.files.size());
  }
  const int code = print(text);
  return remade.differing.empty() ? code : failed;
}

int look(const DatasetArguments& options) {
  if (!options.output.empty()) check_picture_path(options.output);
  const Run run(options.run);
  const std::string path = options.output.empty()
                               ? (std::filesystem::path(options.folder) / "look.png").string()
                               : options.output;
  render::write_png(path, contact_sheet(options.folder, options.sheet, run.context()),
                    run.context());
  return done;
}

/// A verb of `dataset` that works on the folder of a set.
CLI::App* add_verb(CLI::App& dataset, const char* name, const char* text,
                   DatasetArguments& options) {
  CLI::App* verb = dataset.add_subcommand(name, text);
  verb->add_option("DIR", options.folder, "The folder of a set")->required()->type_name("");
  return verb;
}

void add_verbs(CLI::App& dataset, const std::shared_ptr<DatasetArguments>& options,
               Action& action) {
  CLI::App* verb = add_verb(dataset, "verify", "Check every byte of a set", *options);
  add_run_options(*verb, options->run, "Only what is wrong");
  verb->callback([options, &action] { action = [options] { return verify(*options); }; });

  verb = add_verb(dataset, "sample", "Make a sample again and compare it", *options);
  verb->add_option("ID", options->sample, "The sample's number")->required()->type_name("");
  verb->add_option("-o,--output", options->output, "Write its files to this folder")
      ->type_name("DIR");
  add_run_options(*verb, options->run, "Only what differs");
  verb->callback([options, &action] { action = [options] { return remake(*options); }; });

  verb = add_verb(dataset, "look", "Samples side by side, with their labels over them", *options);
  verb->add_option("-o,--output", options->output, "The picture; DIR/look.png where not given")
      ->type_name("FILE");
  verb->add_option("--count", options->sheet.samples, "How many samples")
      ->check(CLI::Range(1, 400))
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--columns", options->sheet.columns, "In a row")
      ->check(CLI::Range(1, 20))
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--size", options->sheet.size, "Width of each picture, pixels")
      ->check(CLI::Range(32, 2048))
      ->type_name("N")
      ->capture_default_str();
  add_run_options(*verb, options->run);
  verb->callback([options, &action] { action = [options] { return look(*options); }; });
}

}  // namespace

void add_dataset(CLI::App& app, Action& action) {
  const auto options = std::make_shared<DatasetArguments>();
  CLI::App* verb = app.add_subcommand("dataset", "Make pictures of cracks with exact labels");
  verb->require_subcommand(0, 1);
  CLI::Option* plan = verb->add_option("PLAN", options->plan, "A plan, TOML: docs/datasets.md");
  plan->type_name("");
  CLI::Option* folder =
      verb->add_option("-o,--output", options->output, "Where the set goes")->type_name("DIR");
  CLI::Option* shard =
      verb->add_option(
              "--shard", options->shard,
              "Do only every N-th archive, for one of N processes or machines; all may write "
              "to one folder")
          ->type_name("i/N");
  CLI::Option* samples =
      verb->add_option("--samples", options->samples, "Instead of the number in the plan")
          ->check(CLI::Range(1, 1000000000))
          ->type_name("N");
  CLI::Option* keys = verb->add_flag("--keys", options->keys, "List the keys of such plans");
  for (CLI::Option* other : {plan, folder, shard, samples}) keys->excludes(other);
  add_run_options(*verb, options->run, "No progress, no word at the end");
  verb->footer(
      "Examples:\n"
      "  craze dataset recipes/datasets/pavement.toml -o pavement --samples 1000\n"
      "  craze dataset wall.toml -o wall --shard 3/16\n"
      "  parallel craze dataset wall.toml -o wall --threads 1 --shard {}/8 ::: $(seq 8)\n"
      "  craze dataset verify wall\n"
      "  craze dataset sample wall 17 -o sample_17\n"
      "  craze dataset look wall -o sheet.png\n"
      "A set that was stopped, even killed, goes on where it was when started again, with any "
      "number of shards; so does a whole one with a larger --samples.");
  add_verbs(*verb, options, action);
  for (CLI::App* of_set : verb->get_subcommands({})) {
    for (CLI::Option* making : {plan, folder, shard, samples, keys}) of_set->excludes(making);
  }
  verb->callback([verb, options, plan, folder, keys, &action] {
    if (!verb->get_subcommands().empty()) return;
    if (keys->empty()) {
      if (plan->empty()) throw CLI::RequiredError("PLAN");
      if (folder->empty()) throw CLI::RequiredError("--output");
    }
    action = [options] { return make(*options); };
  });
}

}  // namespace craze::app
