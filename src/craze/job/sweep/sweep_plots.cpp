#include "craze/job/sweep/sweep_plots.h"

#include <algorithm>
#include <cmath>

#include "craze/base/elementary.h"
#include "craze/base/parse_double.h"
#include "craze/base/text/format.h"
#include "craze/io/files/atomic_file.h"
#include "craze/job/output_folder.h"
#include "craze/products/statistics/plots/plots.h"
#include "craze/recipe/length_text.h"

namespace craze {

namespace {

constexpr int intervals = 12;

bool read_number(const std::string& cell, double& x) {
  return parse_double(cell.data(), cell.data() + cell.size(), x).ec == std::errc() &&
         std::isfinite(x);
}

}  // namespace

void SweepPlots::Sum::add(double value, double error) {
  if (runs == 0) own_error = error;
  ++runs;
  const double off = value - mean;  // Welford's recurrence
  mean += off / static_cast<double>(runs);
  squares += off * (value - mean);
}

double SweepPlots::Sum::error() const {
  if (runs < 2) return own_error;
  const auto n = static_cast<double>(runs);
  return std::sqrt(squares / (n - 1) / n);
}

SweepPlots::SweptKey SweepPlots::axis_of(const PlanEntry& entry, std::size_t column) {
  SweptKey axis{entry.key, column};
  std::vector<PlanValue> values;
  if (const auto* grid = std::get_if<Axis>(&entry.distribution)) values = grid->values;
  if (const auto* choice = std::get_if<Choice>(&entry.distribution)) values = choice->values;
  const auto first = values.empty() ? std::nullopt : plan_length(values.front());
  for (const PlanValue& value : values) {
    const auto number = plan_length(value);
    axis.numbers &= first && number && number->unit() == first->unit();
  }
  if (axis.numbers) {
    std::sort(values.begin(), values.end(), [](const PlanValue& a, const PlanValue& b) {
      return plan_length(a)->number() < plan_length(b)->number();
    });
  }
  for (const PlanValue& value : values) {
    const std::string cell = plan_text(value);
    if (std::find(axis.cells.begin(), axis.cells.end(), cell) != axis.cells.end()) continue;
    const auto* number = std::get_if<double>(&value);
    axis.x.push_back(axis.numbers ? plan_length(value)->number()
                                  : static_cast<double>(axis.cells.size()));
    axis.labels.push_back(number ? fmt::format("{:.4g}", *number) : cell);
    axis.cells.push_back(cell);
  }
  if (const auto* even = std::get_if<Uniform>(&entry.distribution)) {
    axis.low = even->low;
    axis.high = even->high;
  } else if (const auto* log = std::get_if<LogUniform>(&entry.distribution)) {
    axis.low = elementary::log(log->low);
    axis.high = elementary::log(log->high);
    axis.logarithmic = true;
  } else if (const auto* normal = std::get_if<Normal>(&entry.distribution)) {
    axis.low = normal->low;
    axis.high = normal->high;
  } else {
    return axis;
  }
  axis.intervals = true;
  for (int i = 0; i < intervals; ++i) {
    const double middle = axis.low + (i + 0.5) / intervals * (axis.high - axis.low);
    axis.x.push_back(axis.logarithmic ? elementary::exp(middle) : middle);
    axis.labels.push_back(fmt::format("{:.3g}", axis.x.back()));
  }
  return axis;
}

std::size_t SweepPlots::SweptKey::place_of(const std::string& cell) const {
  if (!intervals) {
    return static_cast<std::size_t>(std::find(cells.begin(), cells.end(), cell) - cells.begin());
  }
  const auto length = parse_length(cell);
  if (!length || !(high > low)) return labels.size();
  const double value = length->number();
  const double share = ((logarithmic ? elementary::log(value) : value) - low) / (high - low);
  return static_cast<std::size_t>(
      std::clamp(std::floor(share * craze::intervals), 0.0, craze::intervals - 1.0));
}

SweepPlots::SweepPlots(const SweepRows& rows) : columns_(sweep_columns(rows)) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].name == "status") status_ = i;
    if (i > 0 && columns_[i].name == columns_[i - 1].name + ".error") statistics_.push_back(i - 1);
  }
  for (const PlanEntry& entry : rows.plan().entries()) {
    const auto column = std::find_if(columns_.begin(), columns_.end(),
                                     [&](const SweepColumn& c) { return c.name == entry.key; });
    if (column == columns_.end() || std::holds_alternative<Linked>(entry.distribution)) continue;
    axes_.push_back(axis_of(entry, static_cast<std::size_t>(column - columns_.begin())));
    SweptKey& axis = axes_.back();
    axis.sums.assign(axis.labels.size(), std::vector<Sum>(statistics_.size()));
  }
}

void SweepPlots::add(const std::vector<std::string>& cells) {
  if (cells[status_] != "ok") return;
  for (SweptKey& axis : axes_) {
    const std::size_t place = axis.place_of(cells[axis.column]);
    if (place == axis.labels.size()) continue;
    for (std::size_t s = 0; s < statistics_.size(); ++s) {
      double value = 0, error = 0;
      if (!read_number(cells[statistics_[s]], value)) continue;
      if (!read_number(cells[statistics_[s] + 1], error)) error = 0;
      axis.sums[place][s].add(value, error);
    }
  }
}

void SweepPlots::write(const std::filesystem::path& folder, const Context& context) const {
  for (const SweptKey& axis : axes_) {
    make_output_folder("the plots", folder / axis.key);
    for (std::size_t s = 0; s < statistics_.size(); ++s) {
      std::vector<PlotPoint> points;
      for (std::size_t i = 0; i < axis.labels.size(); ++i) {
        const Sum& sum = axis.sums[i][s];
        if (sum.runs == 0) continue;
        points.push_back({axis.x[i], axis.labels[i], sum.mean, sum.error(), sum.runs});
      }
      if (points.empty()) continue;
      const std::string& name = columns_[statistics_[s]].name;
      write_file(folder / axis.key / (name + ".svg"),
                 error_bars_svg(points, {name, axis.key, axis.logarithmic, axis.numbers}),
                 "cannot write a plot", context);
    }
  }
}

}  // namespace craze
