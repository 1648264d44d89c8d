#include "craze/base/work_and_span.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <numeric>
#include <queue>

namespace craze {

double time_on_cores(const std::vector<double>& tasks, int cores) {
  assert(cores > 0);
  if (cores == 1) return std::accumulate(tasks.begin(), tasks.end(), 0.0);
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
  double end = 0;
  for (const double task : tasks) {
    double start = 0;
    if (free_at.size() == static_cast<std::size_t>(cores)) {
      start = free_at.top();
      free_at.pop();
    }
    free_at.push(start + task);
    end = std::max(end, start + task);
  }
  return end;
}

void WorkAndSpan::add(const std::string& loop, double before, const std::vector<double>& tasks) {
  Row& row = rows_[loop];
  ++row.loops;
  row.tasks += static_cast<std::int64_t>(tasks.size());
  row.before += before;
  for (std::size_t i = 0; i < cores.size(); ++i) row.inside[i] += time_on_cores(tasks, cores[i]);
}

double WorkAndSpan::total(std::size_t i, double after) const {
  double seconds = after;
  for (const auto& [name, row] : rows_) seconds += row.before + row.inside[i];
  return seconds;
}

}  // namespace craze
