// The values of a parameter that are most likely to break something.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "craze/recipe/parameter_table.h"

namespace craze::test {

inline double clamped(const ParameterRange& range, double x) {
  constexpr double greatest = 1e300, least = 1e-300;
  const double low = range.low_open ? range.low + least : range.low;
  return std::min(std::max(x, std::max(low, -greatest)), std::min(range.high, greatest));
}

/// The ends of its range, zero and one, as far as they are in it.
inline std::vector<ParameterValue> edges_of(const Parameter& p) {
  std::vector<ParameterValue> values;
  for (const double x : {-1e300, 0.0, 1.0, 1e300}) {
    const double inside = clamped(p.range, x);
    switch (p.type) {
      case ParameterType::real:
      case ParameterType::length:
      case ParameterType::edge:
        values.emplace_back(inside);
        break;
      case ParameterType::integer:
        values.emplace_back(static_cast<std::int64_t>(inside));
        break;
      case ParameterType::vec2:
        values.emplace_back(std::vector<double>(2, inside));
        break;
      case ParameterType::vec3:
        values.emplace_back(std::vector<double>(3, inside));
        break;
      case ParameterType::tensor6:
        values.emplace_back(std::vector<double>(6, inside));
        break;
      default:
        break;
    }
  }
  for (const std::string& word : p.choices) values.emplace_back(word);
  if (p.type == ParameterType::boolean) values = {true, false};
  return values;
}

}  // namespace craze::test
