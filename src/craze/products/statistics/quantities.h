// The one list of measured quantities: feeds the JSON, the table and the docs.
#pragma once

#include <span>
#include <string_view>

#include "craze/products/statistics/statistics.h"

namespace craze {

struct Quantity {
  std::string_view key;   ///< dotted, as in the report: "angles.t"
  std::string_view text;  ///< a line of the table
  Estimate Statistics::*value;
};

std::span<const Quantity> quantities();

}  // namespace craze
