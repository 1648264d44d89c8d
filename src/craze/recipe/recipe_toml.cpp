// Recipes from TOML or JSON text, and single settings from the command line.

#include <toml++/toml.h>
#include <cctype>
#include <charconv>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/recipe/nearest_name.h"
#include "craze/recipe/parameter_table.h"
#include "craze/recipe/set_key.h"
#include "craze/recipe/toml_text.h"

namespace craze {

namespace {

constexpr std::string_view impact_prefix = "impact.";

[[noreturn]] void fail(const std::string& what, const std::string& where, const std::string& why) {
  throw Error(ErrorKind::usage, what, where, why);
}

[[noreturn]] void fail_unknown(const std::string& key, const std::string& where) {
  if (key == "preset") {
    fail("unknown key preset", where,
         "a recipe names no preset: give --preset, or begin with the text that craze presets NAME "
         "prints");
  }
  std::vector<std::string> keys{"impact"};
  for (const Parameter& p : parameter_table()) keys.push_back(p.key);
  const std::string nearest = nearest_name(key, keys);
  fail("unknown key " + key, where,
       nearest.empty() ? "craze parameters lists the keys" : "did you mean " + nearest + "?");
}

std::optional<ParameterValue> to_names(const toml::node& node) {
  if (const auto* x = node.as_string()) {
    return x->get().empty() ? std::vector<std::string>{} : std::vector<std::string>{x->get()};
  }
  const auto* array = node.as_array();
  if (!array) return std::nullopt;
  std::vector<std::string> names;
  for (const toml::node& element : *array) {
    if (!element.is_string()) return std::nullopt;
    names.push_back(*element.value<std::string>());
  }
  return names;
}

/// The node's value in the type that the parameter asks for; a whole number serves as a real one,
/// and a name as a list of one, no letters as none.
std::optional<ParameterValue> to_value(const toml::node& node, ParameterType type) {
  if (type == ParameterType::names) return to_names(node);
  const bool wants_real = type != ParameterType::integer;
  if (const auto* x = node.as_integer()) {
    return wants_real ? ParameterValue(static_cast<double>(x->get())) : ParameterValue(x->get());
  }
  if (const auto* x = node.as_floating_point()) return x->get();
  if (const auto* x = node.as_boolean()) return x->get();
  if (const auto* x = node.as_string()) return x->get();
  const auto* array = node.as_array();
  if (!array) return std::nullopt;
  std::vector<double> numbers;
  for (const toml::node& element : *array) {
    if (!element.is_number()) return std::nullopt;
    numbers.push_back(*element.value<double>());
  }
  return numbers;
}

/// Error messages name the place of a node: "FILE:LINE:COLUMN", or the --set it came from.
using Locator = std::function<std::string(const toml::node&)>;

void set_node(Recipe& recipe, const Parameter& p, std::size_t index, const toml::node& node,
              const std::string& key, const Locator& locate) {
  const auto value = to_value(node, p.type);
  if (!value) fail("wrong type for " + key, locate(node), "must be " + type_in_words(p.type));
  check_value(p, *value, key, locate(node));
  p.set(recipe, index, *value);
}

void set_leaf(Recipe& recipe, std::size_t index, const std::string& key, const toml::node& node,
              const Locator& locate) {
  const Parameter* p = find_parameter(key);
  if (!p) fail_unknown(key, locate(node));
  set_node(recipe, *p, index, node, key, locate);
}

void read_section(Recipe& recipe, const std::string& section, const toml::table& table,
                  std::size_t index, const Locator& locate) {
  for (const auto& [name, node] : table) {
    const std::string key = section + "." + std::string(name.str());
    set_leaf(recipe, index, key, node, locate);
    const std::string& same = find_parameter(key)->instead_of;  // in the same section
    if (same.empty() || table.contains(same.substr(section.size() + 1))) continue;
    const Parameter& other = *find_parameter(same);
    other.set(recipe, index, other.default_value());
  }
}

void read_impacts(Recipe& recipe, const toml::node& node, const Locator& locate) {
  const auto* array = node.as_array();
  if (!array || (!array->empty() && !array->is_array_of_tables())) {
    fail("wrong type for impact", locate(node), "write each impact under its own [[impact]]");
  }
  recipe.simulation.impacts.clear();
  for (const toml::node& element : *array) {
    recipe.simulation.impacts.emplace_back();
    read_section(recipe, "impact", *element.as_table(), recipe.simulation.impacts.size() - 1,
                 locate);
  }
}

bool is_section(const std::string& name) {
  for (const Parameter& p : parameter_table()) {
    if (p.section() == name) return true;
  }
  return false;
}

/// "impact.2.radius" → {2, "impact.radius"}; other keys keep their name and index 0.
struct Target {
  std::size_t index = 0;
  std::string key;
};

Target find_target(const Recipe& recipe, const std::string& key, const std::string& where) {
  if (key.compare(0, impact_prefix.size(), impact_prefix) != 0) return {0, key};
  const char* begin = key.data() + impact_prefix.size();
  const char* end = key.data() + key.size();
  std::size_t index = 0;
  const auto [rest, status] = std::from_chars(begin, end, index);
  const std::size_t count = recipe.simulation.impacts.size();
  if (status != std::errc() || rest == end || *rest != '.') {
    fail("unknown key " + key, where, "write the impact's number, as in impact.0.radius");
  }
  if (index > count) {
    fail("no impact " + std::string(begin, rest), where,
         fmt::format("the recipe has {}, so the next is impact.{}", count, count));
  }
  return {index, std::string(impact_prefix) + std::string(rest + 1, end)};
}

/// Whether the value may be text without quotes.
bool takes_words(ParameterType type, const std::string& text) {
  if (type == ParameterType::names) return text.empty() || text[0] != '[';
  return type == ParameterType::string || type == ParameterType::choice ||
         type == ParameterType::length || type == ParameterType::edge;
}

/// Numbers as people write them, ".06", "1.", "+1", as TOML wants them: "0.06", "1.0", "+1". All
/// else is left as it is.
std::string with_whole_numbers(const std::string& text) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool before = i > 0 && is_digit(text[i - 1]);
    const bool after = i + 1 < text.size() && is_digit(text[i + 1]);
    if (text[i] == '.' && after && !before) result += '0';
    result += text[i];
    if (text[i] == '.' && before && !after) result += '0';
  }
  return result;
}

/// The text after "=" as a node: TOML, or the bare text where the parameter takes words.
toml::table parse_setting(const Parameter& p, const std::string& text, const std::string& where) {
  const bool quoted = !text.empty() && (text[0] == '"' || text[0] == '\'');
  const bool words = takes_words(p.type, text);
  const bool has_text = quoted || p.type == ParameterType::names;
  toml::table table;
  const std::string toml = "value = " + (has_text ? text : with_whole_numbers(text));
  if ((p.is_length() || quoted || !words) && !find_toml_fault(toml)) {
    try {
      check_toml_nesting(text, where, "recipe");
      table = toml::parse(toml);
      if (table.size() == 1 && !table["value"].is_table()) return table;
    } catch (const toml::parse_error&) {
      table.clear();
    }
  }
  if (!words || quoted) {
    fail("wrong type for " + p.key, where, "must be " + type_in_words(p.type));
  }
  table.clear();
  table.insert("value", text);
  return table;
}

}  // namespace

Recipe read_recipe(std::string_view text, const std::string& name, const Recipe& base) {
  const toml::table root = parse_toml(text, name, "recipe");
  const Locator locate = [&](const toml::node& node) {
    const auto at = node.source().begin;
    return at ? fmt::format("{}:{}:{}", name, at.line, at.column) : name;  // none in JSON
  };
  Recipe recipe = base;
  for (const auto& [toml_key, node] : root) {
    const std::string key(toml_key.str());
    if (key == "impact") {
      read_impacts(recipe, node, locate);
    } else if (is_section(key) && !key.empty()) {
      if (!node.is_table()) fail("wrong type for " + key, locate(node), "must be a section");
      read_section(recipe, key, *node.as_table(), 0, locate);
    } else if (const auto* table = node.as_table(); table && !table->empty()) {
      read_section(recipe, key, *table, 0, locate);
    } else {
      set_leaf(recipe, 0, key, node, locate);
    }
  }
  return recipe;
}

Recipe read_recipe_file(const std::string& path, const Recipe& base) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  if (file) {
    text.resize(toml_size_limit + 1);
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
  }
  if (!file && !file.eof()) {
    throw Error(ErrorKind::input, "cannot read the recipe", path, "no such file, or not readable");
  }
  return read_recipe(text, path, base);
}

void set_key(Recipe& recipe, const std::string& key, const std::string& value,
             const std::string& where) {
  const Target target = find_target(recipe, key, where);
  const Parameter* p = find_parameter(target.key);
  if (!p) fail_unknown(target.key, where);
  const toml::table table = parse_setting(*p, value, where);
  Recipe changed = recipe;
  if (p->repeated() && target.index == changed.simulation.impacts.size()) {
    changed.simulation.impacts.emplace_back();
  }
  set_node(changed, *p, target.index, *table.get("value"), key,
           [&](const toml::node&) { return where; });
  recipe = std::move(changed);
}

void apply_set(Recipe& recipe, const std::string& assignment) {
  const std::string where = "--set " + assignment;
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    fail("not a setting", where, "write --set key=value");
  }
  set_key(recipe, assignment.substr(0, equals), assignment.substr(equals + 1), where);
}

}  // namespace craze
