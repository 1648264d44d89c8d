// How much faster a run would be on many cores, from its times on one: which part of it each loop
// is, and what lies between the loops.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace craze {

/// Seconds until tasks of these lengths are done on so many cores, each of which takes the next one
/// when it has done its last.
double time_on_cores(const std::vector<double>& tasks, int cores);

/// Times of the loops of a run and of the stretches before, between and after them, by the names of
/// the loops.
class WorkAndSpan {
 public:
  static constexpr std::array<int, 6> cores = {1, 2, 4, 8, 16, 64};

  struct Row {
    std::int64_t loops = 0, tasks = 0;
    double before = 0;  ///< seconds in one thread between the loop before and this one
    std::array<double, cores.size()> inside{};  ///< seconds in the loops, on each number of cores
  };

  /// A stretch of `before` seconds in one thread, then a loop of tasks of so many seconds.
  void add(const std::string& loop, double before, const std::vector<double>& tasks);

  const std::map<std::string, Row>& rows() const { return rows_; }
  /// Seconds of all rows on cores[i], `after` of one thread at the end included. Opening a loop
  /// costs nothing.
  double total(std::size_t i, double after) const;

 private:
  std::map<std::string, Row> rows_;
};

}  // namespace craze
