// The value of one parameter, whatever its type, on its way between text and a recipe's field.
#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

namespace craze {

enum class ParameterType {
  real,
  integer,
  boolean,
  choice,
  string,
  names,
  vec2,
  vec3,
  tensor6,
  length,
  edge
};

/// real: double; integer: int64; boolean: bool; choice, string: text; names: any number of texts;
/// vec2: 2 numbers or none; vec3, tensor6: 3 or 6 numbers; length: a number (double), or text with
/// its unit; edge: that, or a word.
using ParameterValue = std::variant<double, std::int64_t, bool, std::string, std::vector<double>,
                                    std::vector<std::string>>;

/// Which numbers a parameter may take. Infinite ends stand for "no limit"; no value is infinite.
struct ParameterRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;  ///< low itself is not allowed

  bool contains(double x) const { return (low_open ? x > low : x >= low) && x <= high; }
};

/// "real", "integer", …, as in the JSON dump; lengths are reals there, which may have a unit.
std::string type_name(ParameterType type);

/// What an error says a value must be: "a number", "three numbers [x, y, z]", …
std::string type_in_words(ParameterType type);

/// "at least 0", "more than 0", "in [0, 1]", "any number".
std::string range_in_words(const ParameterRange& range, ParameterType type);

/// As TOML: the shortest text that reads back as the same value. Reals keep a point or exponent.
std::string format_value(const ParameterValue& value);

nlohmann::ordered_json value_to_json(const ParameterValue& value);

}  // namespace craze
