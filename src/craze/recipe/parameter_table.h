// The one table of every parameter. It feeds recipes, --set, the listing and the reference page,
// error messages, and the JSON that the bindings read.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "craze/recipe.h"
#include "craze/recipe/parameter_value.h"

namespace craze {

struct Parameter {
  std::string key;  ///< dotted: "material.toughness"
  ParameterType type = ParameterType::real;
  ParameterRange range;              ///< of each number; unused for words
  std::vector<std::string> choices;  ///< the words allowed, for choice and edge
  std::string symbol;                ///< the paper's, may be empty
  std::string unit;                  ///< may be empty: a pure number
  std::string help;                  ///< one line
  std::string source;                ///< section or equation, may be empty
  /// The key of the section that says the same in another way, may be empty. A text that gives one
  /// of the two alone takes the other back.
  std::string instead_of;

  /// The field in a recipe. `index` picks the impact for impact.* keys and is ignored otherwise.
  std::function<ParameterValue(const Recipe&, std::size_t index)> get;
  /// Takes a value that check_value accepts.
  std::function<void(Recipe&, std::size_t index, const ParameterValue&)> set;

  std::string section() const;  ///< "material"; empty for the keys at the top
  std::string name() const;     ///< "toughness"
  /// One of any number: the keys of [[impact]].
  bool repeated() const { return section() == "impact"; }
  /// Numbers that may have a unit (length_text.h).
  bool is_length() const { return type == ParameterType::length || type == ParameterType::edge; }
  /// As in a recipe that says nothing.
  ParameterValue default_value() const;
};

/// In the order of a recipe, section by section.
const std::vector<Parameter>& parameter_table();

/// The parameter with that dotted key (without an impact's number), or nullptr.
const Parameter* find_parameter(std::string_view key);

/// Throws Error(usage) where the value has the wrong type or is out of range. `key` is the key as
/// the user wrote it, `where` the place.
void check_value(const Parameter& parameter, const ParameterValue& value, const std::string& key,
                 const std::string& where);

/// The table as a JSON array, for the bindings: key, section, name, type, default, minimum,
/// maximum, exclusive_minimum, choices, units, symbol, unit, help, source, instead_of, repeated.
nlohmann::ordered_json parameters_to_json();

}  // namespace craze
