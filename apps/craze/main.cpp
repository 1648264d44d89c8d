// The craze command: reads the command line, runs one verb, turns errors into one line and a code.
#include <algorithm>
#include <csignal>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "app.h"
#include "craze/base/version.h"
#include "craze/error.h"
#include "craze/recipe/nearest_name.h"
#include "terminal/error_line.h"
#include "terminal/message_style.h"
#include "terminal/standard_streams.h"

namespace {

using namespace craze::app;

/// "craze crack": the verb that a wrong word was said to.
std::string said_to(const CLI::App& app) {
  const auto verbs = app.get_subcommands();
  return verbs.empty() ? "craze" : "craze " + verbs.front()->get_name();
}

/// A first word that is no verb is met before CLI11 calls it a missing one.
void check_verb(const CLI::App& app, const std::string& word) {
  if (word.empty() || word[0] == '-') return;
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  if (std::find(verbs.begin(), verbs.end(), word) != verbs.end()) return;
  const std::string nearest = craze::nearest_name(word, verbs);
  throw craze::Error(craze::ErrorKind::usage, "unknown verb " + word, "craze",
                     nearest.empty() ? "see craze --help" : "did you mean " + nearest + "?");
}

/// Where an option of the verb is misspelt: "unknown option --presett (craze crack): did you mean
/// --preset?", else "".
std::string misspelt_option(const CLI::App& app, int argc, char** argv) {
  const CLI::App* verb = &app;
  while (!verb->get_subcommands().empty()) verb = verb->get_subcommands().front();
  std::vector<std::string> known;
  for (const CLI::Option* option : verb->get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i], option = word.substr(0, word.find('='));
    if (!option.starts_with("--") || option == "--") continue;
    if (std::find(known.begin(), known.end(), option) != known.end()) continue;
    const std::string nearest = craze::nearest_name(option, known);
    if (nearest.empty()) continue;
    return "unknown option " + option + " (" + said_to(app) + "): did you mean " + nearest + "?";
  }
  return "";
}

int run_command(int argc, char** argv, MessageStyle style) {
  CLI::App app{"Grows surface crack patterns on triangle meshes: mud, glaze, glass, paint.",
               "craze"};
  app.set_version_flag("--version", "craze " + craze::version());
  app.set_help_all_flag("--help-all", "Print the help of every verb");
  app.footer(
      "Examples:\n"
      "  craze crack cup.obj -o cracked.glb --preset glaze --picture cracked.png\n"
      "  craze crack shape:plate?n=99 -o mud.ply --preset mud --set material.alpha=0.9\n"
      "  craze check scan.stl\n"
      "craze VERB --help says more about each.");
  app.require_subcommand(1);
  Action action;
  add_crack(app, action);
  add_render(app, action);
  add_bake(app, action);
  add_texture(app, action);
  add_stats(app, action);
  add_check(app, action);
  add_dataset(app, action);
  add_sweep(app, action);
  add_figures(app, action);
  add_studio(app, action);
  add_presets(app, action);
  add_parameters(app, action);
  if (argc > 1) check_verb(app, argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    std::ostringstream help;
    app.exit(e, help, help);
    const std::string text = help.str();
    return print(text.back() == '\n' ? text : text + "\n");
  } catch (const CLI::ParseError& e) {
    const bool has_more = dynamic_cast<const CLI::ExtrasError*>(&e) != nullptr;
    if (const std::string said = has_more ? misspelt_option(app, argc, argv) : ""; !said.empty()) {
      print_error(style, said);
      return wrong_usage;
    }
    const std::string verb = said_to(app);
    print_error(style, "wrong usage (" + verb + "): " + e.what() + "; see " + verb + " --help");
    return wrong_usage;
  }
  return action();
}

/// Arrays of four megabytes or more go back to the system when they are freed. The C library would
/// come to keep those of up to 32.
void give_back_large_arrays() {
#ifdef __GLIBC__
  constexpr int megabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 4 * megabyte);
  mallopt(M_TRIM_THRESHOLD, 8 * megabyte);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  give_back_large_arrays();
  fill_standard_streams();
  // A closed pipe and a limit on file sizes are failures to write, not ends of the process.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const MessageStyle style = message_style(argc, argv);
  return exit_code_of(style, [&] { return run_command(argc, argv, style); });
}
