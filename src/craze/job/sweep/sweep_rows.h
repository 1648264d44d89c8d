// What a sweep runs, row by row.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "craze/job/plan/plan.h"

namespace craze {

/// The keys of sweep plans besides those of recipes.
const PlanSchema& sweep_schema();

/// Every point of the grid, each drawn `draws` times, each with `repeats` seeds: the last vary
/// fastest.
class SweepRows {
 public:
  /// Throws Error(usage) for more than 10⁹ rows.
  explicit SweepRows(Plan plan);

  const Plan& plan() const { return plan_; }
  std::uint64_t count() const { return count_; }
  /// Rows of a part: what is written, and done again after a stop, as a whole.
  std::uint64_t rows_of_part() const { return rows_of_part_; }
  std::uint64_t part_count() const { return (count_ + rows_of_part_ - 1) / rows_of_part_; }

  /// How many are in a part, of which the last may have fewer.
  std::uint64_t rows_of(std::uint64_t part) const {
    return std::min(rows_of_part_, count_ - part * rows_of_part_);
  }
  /// Whether the rows of a plan that is the same but for its draws and repeats are the first of
  /// these.
  bool begin_with(const SweepRows& other) const;

  /// The values of a row. Rows that differ in their seed alone have the same values.
  PlanValues values(std::uint64_t row) const;
  /// Seeds are the same at every point, so that points differ by their values alone.
  std::uint64_t seed(std::uint64_t row) const;
  /// The keys that are not the same in all rows, in the plan's order.
  const std::vector<std::string>& varied() const { return varied_; }

 private:
  Plan plan_;
  std::uint64_t repeats_, draws_, count_, rows_of_part_;
  std::vector<std::size_t> axes_;  // entries of the plan
  std::vector<std::string> varied_;
};

}  // namespace craze
