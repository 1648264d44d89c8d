// What the verbs share. Each verb is one file with one function that adds it to the command.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "craze/length.h"
#include "terminal/exit_code.h"
#include "terminal/print.h"

namespace craze::app {

/// What the chosen verb does; set while the command line is read, called after it.
using Action = std::function<int()>;

void add_crack(CLI::App& app, Action& action);
void add_bake(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_render(CLI::App& app, Action& action);
void add_stats(CLI::App& app, Action& action);
void add_figures(CLI::App& app, Action& action);
void add_sweep(CLI::App& app, Action& action);
void add_dataset(CLI::App& app, Action& action);
void add_studio(CLI::App& app, Action& action);
void add_texture(CLI::App& app, Action& action);
void add_presets(CLI::App& app, Action& action);
void add_parameters(CLI::App& app, Action& action);

/// For options that take a number: any finite one, one of 0 or more, one from low to high.
CLI::Validator any_number();
CLI::Validator not_negative();
CLI::Validator number_in(double low, double high);

/// For options that take a length of 0 or more, with a unit or without: kept as parse_length reads
/// it (recipe/length_text.h).
CLI::Option* add_length(CLI::App& verb, const std::string& name, Length& length,
                        const std::string& help);

}  // namespace craze::app
