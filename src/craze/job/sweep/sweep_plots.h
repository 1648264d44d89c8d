// How each statistic of a sweep goes with each key that varies, as plots.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/job/sweep/sweep_rows.h"
#include "craze/job/sweep/sweep_table.h"

namespace craze {

/// Takes the rows one by one. A point is the mean of all rows that have the key's value there,
/// whatever the others are, with its standard error, or with the row's own error where it is one.
/// Values of grids and choices have a point each; what is drawn evenly or by a normal law falls
/// into twelve intervals of its range. Keys that are linked have no plots: they go with another.
class SweepPlots {
 public:
  explicit SweepPlots(const SweepRows& rows);

  /// A row's cells, one for each of sweep_columns().
  void add(const std::vector<std::string>& cells);
  /// FOLDER/KEY/STATISTIC.svg. Statistics that no row has are left out. Throws Error(output) and
  /// Cancelled.
  void write(const std::filesystem::path& folder, const Context& context) const;

 private:
  /// Values of a statistic at one place of a key.
  struct Sum {
    std::uint64_t runs = 0;
    double mean = 0, squares = 0;  ///< squares: of the deviations from the mean
    double own_error = 0;          ///< the first row's

    void add(double value, double error);
    double error() const;
  };
  /// A key's places, in order.
  struct SweptKey {
    std::string key;
    std::size_t column = 0;
    std::vector<std::string> cells = {};   ///< of places: what rows have there; of intervals none
    std::vector<std::string> labels = {};  ///< of places
    std::vector<double> x = {};            ///< of places
    bool intervals = false, logarithmic = false, numbers = true;
    double low = 0, high = 0;                 ///< of the intervals
    std::vector<std::vector<Sum>> sums = {};  ///< by place and statistic

    std::size_t place_of(const std::string& cell) const;  ///< the number of places: none
  };
  static SweptKey axis_of(const PlanEntry& entry, std::size_t column);

  std::vector<SweepColumn> columns_;
  std::vector<std::size_t> statistics_;  // columns that have an error behind them
  std::size_t status_ = 0;
  std::vector<SweptKey> axes_;
};

}  // namespace craze
