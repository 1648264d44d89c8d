#include "craze/job/sweep/sweep_rows.h"

#include <utility>

#include "craze/base/text/format.h"
#include "craze/error.h"

namespace craze {

namespace {

constexpr std::uint64_t most_rows = 1'000'000'000;

}  // namespace

const PlanSchema& sweep_schema() {
  static const PlanSchema schema{
      "sweep",
      {{.key = "seed",
        .type = PlanKeyType::integer,
        .standard = 1.0,
        .low = 0,
        .high = 9007199254740000.0,
        .fixed = true,
        .help = "the first seed of the runs, and of what is drawn"},
       {.key = "repeats",
        .type = PlanKeyType::integer,
        .standard = 1.0,
        .low = 1,
        .high = 1e9,
        .fixed = true,
        .help = "runs with the same values, each with the next seed",
        .extent = true},
       {.key = "draws",
        .type = PlanKeyType::integer,
        .standard = 1.0,
        .low = 1,
        .high = 1e9,
        .fixed = true,
        .help = "times that what is random is drawn at each point of the grid",
        .extent = true},
       {.key = "part_rows",
        .type = PlanKeyType::integer,
        .standard = 16.0,
        .low = 1,
        .high = 100000,
        .fixed = true,
        .help = "rows that are written, and done again after a stop, as a whole"},
       {.key = "object",
        .type = PlanKeyType::word,
        .standard = std::string("shape:plate?n=60&jitter=0.3"),
        .help = "a mesh file, seen from the plan's folder, or shape:NAME?key=value&…"}},
      true};
  return schema;
}

SweepRows::SweepRows(Plan plan) : plan_(std::move(plan)) {
  const auto whole = [this](const char* key) {
    return static_cast<std::uint64_t>(plan_.number(key));
  };
  repeats_ = whole("repeats");
  draws_ = whole("draws");
  rows_of_part_ = whole("part_rows");
  count_ = repeats_ * draws_;  // at most 10¹⁸
  for (std::size_t i = 0; i < plan_.entries().size(); ++i) {
    const PlanEntry& e = plan_.entries()[i];
    if (!std::holds_alternative<Constant>(e.distribution)) varied_.push_back(e.key);
    const auto* axis = std::get_if<Axis>(&e.distribution);
    if (!axis) continue;
    axes_.push_back(i);
    if (count_ <= most_rows) count_ *= axis->values.size();
  }
  if (count_ > most_rows) {
    throw Error(ErrorKind::usage, "too many rows", "plan",
                fmt::format("at most {}; take fewer values, draws or repeats", most_rows));
  }
}

bool SweepRows::begin_with(const SweepRows& other) const {
  if (other.repeats_ == repeats_ && other.draws_ == draws_) return true;
  if (count_ != repeats_ * draws_) return false;  // points follow each other
  const bool more_draws = other.repeats_ == repeats_ && other.draws_ <= draws_;
  const bool more_repeats = other.draws_ == 1 && other.repeats_ <= repeats_;
  return more_draws || more_repeats;
}

PlanValues SweepRows::values(std::uint64_t row) const {
  const std::uint64_t drawn = row / repeats_;
  std::uint64_t point = drawn / draws_;
  PlanValues axes;
  for (auto i = axes_.rbegin(); i != axes_.rend(); ++i) {
    const PlanEntry& e = plan_.entries()[*i];
    const auto& of_axis = std::get<Axis>(e.distribution).values;
    axes.emplace(e.key, of_axis[point % of_axis.size()]);
    point /= of_axis.size();
  }
  return plan_.draw(drawn, 0, axes);
}

std::uint64_t SweepRows::seed(std::uint64_t row) const {
  return static_cast<std::uint64_t>(plan_.number("seed")) + row % repeats_;
}

}  // namespace craze
