// Statistics for people and for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "craze/products/statistics/null_models/null_models.h"
#include "craze/products/statistics/statistics.h"

namespace craze {

/// Statistics of a null model, to stand beside a measured pattern.
struct NullRow {
  NullModel model;
  Statistics statistics;
};

/// Poisson–Voronoi, orthogonal splitting and STIT with as many cells, measured by the same options.
std::vector<NullRow> null_rows(const StatisticsOptions& options, std::int32_t cells = 2000,
                               std::uint64_t seed = 1);

/// The report's `statistics` object: every key of quantities() as {"value": …, "error": …}, null
/// where not measured; "counts" and totals; "sensitivity" with the values at half and double the
/// length of simplification; "null" with the values of each null model.
nlohmann::ordered_json to_json(const StatisticsWithSensitivity& statistics,
                               const std::vector<NullRow>& nulls);

/// A table: one line per quantity, its value and error, and a column per null model.
std::string to_text(const StatisticsWithSensitivity& statistics, const std::vector<NullRow>& nulls);

}  // namespace craze
