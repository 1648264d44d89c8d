// How a value of a plan is drawn.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "craze/base/random.h"
#include "craze/length.h"

namespace craze {

/// A number, or the text of anything else: a word, a length with its unit, a list as in TOML.
using PlanValue = std::variant<double, std::string>;

/// As a recipe's text has it: the shortest number that reads back the same; texts as they are.
std::string plan_text(const PlanValue& value);

/// A number; or a text that is a length with a unit. None: another text.
std::optional<Length> plan_length(const PlanValue& value);

/// That length as a value.
PlanValue plan_value(const Length& length);

/// The number of it in that unit; 0 is 0 in all. None where they do not convert into each other.
std::optional<double> in_unit(const Length& length, LengthUnit unit);

struct Constant {
  PlanValue value;
};
// Laws of lengths draw numbers of `unit`; their values are texts then: "3.2mm".
struct Uniform {
  double low, high;  ///< low <= high
  LengthUnit unit = LengthUnit::own;
};
/// Its logarithm is uniform.
struct LogUniform {
  double low, high;  ///< 0 < low <= high
  LengthUnit unit = LengthUnit::own;
};
/// Drawn again until within; what is still outside after many tries is the nearer end.
struct Normal {
  double mean, deviation, low, high;
  LengthUnit unit = LengthUnit::own;
};
struct Choice {
  std::vector<PlanValue> values;  ///< not empty
  std::vector<double> weights;    ///< one per value, their sum above 0; empty: all alike
};
/// Goes with another key: offset + factor × its number, or the value that its text maps to.
struct Linked {
  std::string key;
  double factor = 1;
  Length offset = 0;
  std::map<std::string, PlanValue> map;  ///< not empty: by text
};
/// An axis of a grid: every value comes once with every value of the others.
struct Axis {
  std::vector<PlanValue> values;  ///< not empty
};

using Distribution = std::variant<Constant, Uniform, LogUniform, Normal, Choice, Linked, Axis>;

/// One value; for Linked from `other`, that of its key. An Axis is not drawn.
/// Throws Error(usage) where a map has nothing for `other`.
PlanValue draw(const Distribution& distribution, Random& random, const PlanValue* other,
               const std::string& where);

/// Values that lie at the ends of what can be drawn, or all of them: where these are allowed, all
/// are. None for Linked without a map.
std::vector<PlanValue> extremes(const Distribution& distribution);

}  // namespace craze
