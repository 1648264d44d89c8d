// The table of a sweep: its columns, and its text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "craze/context.h"
#include "craze/job/sweep/sweep_rows.h"

namespace craze {

/// A column of text or of numbers.
struct SweepColumn {
  std::string name;
  bool text = false;
};

/// row, seed, one for each varied key, status ("ok", or why the run failed), what the run did, and
/// each statistic with its standard error, KEY and KEY.error.
std::vector<SweepColumn> sweep_columns(const SweepRows& rows);

/// The cells of a row, as CSV without the line's end: numbers in the shortest text that reads back
/// the same, nothing for what was not measured. A run that cannot be done, by its values or its
/// mesh, has that for its status and no numbers. Throws Cancelled. `folder` is the plan's.
std::string sweep_row(const SweepRows& rows, std::uint64_t row, const std::string& folder,
                      const Context& context);

/// A cell as CSV (RFC 4180) has it.
std::string csv_cell(std::string_view text);
/// The cells of a line without its end.
std::vector<std::string> csv_cells(std::string_view line);

}  // namespace craze
