#include "craze/job/sweep/sweep.h"

#include <algorithm>
#include <vector>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/job/output_folder.h"
#include "craze/job/plan/side_by_side.h"
#include "craze/job/sweep/join_parts.h"
#include "craze/job/sweep/sweep_table.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

std::uint64_t line_count(const std::string& lines) {
  return static_cast<std::uint64_t>(std::count(lines.begin(), lines.end(), '\n'));
}

/// The rows [begin, end), as many at a time as there are threads; each is done by one.
std::string make_rows(const SweepRows& rows, std::uint64_t begin, std::uint64_t end,
                      const std::string& folder, const Context& context) {
  std::string text;
  const auto at_once = static_cast<std::uint64_t>(std::max(1, context.threads.count()));
  for (std::uint64_t first = begin; first < end; first += at_once) {
    context.check();
    std::vector<std::string> lines(std::min(at_once, end - first));
    side_by_side(lines.size(), context, [&](std::size_t i, const Context& own) {
      lines[i] = sweep_row(rows, first + i, folder, own);
    });
    for (const std::string& line : lines) text += line + "\n";
    const std::uint64_t made = first + lines.size() - begin;
    context.report({"sweep", static_cast<double>(made) / static_cast<double>(end - begin)});
  }
  return text;
}

/// The folder's rows, where its plan is the same but for its draws and repeats.
std::optional<SweepRows> same_runs(const SweepRows& rows, const PlanSource& there) {
  try {
    SweepRows held(Plan(there.text, there.name, sweep_schema()));
    if (held.plan().identity() == rows.plan().identity()) return held;
  } catch (const Error&) {  // of another craze, or damaged: another plan
  }
  return std::nullopt;
}

void claim_sweep(const SweepRows& rows, const PlanSource& source, const fs::path& folder,
                 const Context& context) {
  const auto goes_on = [&](const PlanSource& there) {
    const auto held = same_runs(rows, there);
    if (held && held->count() > rows.count()) {
      throw Error(ErrorKind::usage, "the folder holds a larger table", folder.string(),
                  fmt::format("{} rows there, {} asked for; give as many, or an empty folder",
                              held->count(), rows.count()));
    }
    if (held && !rows.begin_with(*held)) {
      throw Error(ErrorKind::usage, "the folder's rows would not be the first", folder.string(),
                  "only more draws without an axis, or more repeats of a single point, come behind "
                  "those there are; give an empty folder");
    }
    return held.has_value();
  };
  claim_plan_folder(folder, source, "sweep", goes_on, context);
}

}  // namespace

std::optional<PlanGrowth> sweep_growth(const PlanSource& source, const fs::path& folder) {
  const SweepRows rows(Plan(source.text, source.name, sweep_schema()));
  const auto there = plan_there(folder);
  const auto held = there ? same_runs(rows, *there) : std::nullopt;
  if (!held || held->count() >= rows.count() || !rows.begin_with(*held)) return std::nullopt;
  PlanGrowth growth{held->count(), rows.count(), {}, 0, 0};
  const std::uint64_t last = held->part_count() - 1;
  const std::uint64_t lines = line_count(whole_lines(part_file(folder, last)));
  if (lines > 0 && lines < rows.rows_of(last)) {
    growth.piece = last;
    growth.held = lines;
    growth.wanted = rows.rows_of(last);
  }
  return growth;
}

SweepResult run_sweep(const PlanSource& source, const fs::path& folder, Shard shard,
                      const Context& context) {
  const SweepRows rows(Plan(source.text, source.name, sweep_schema()));
  claim_sweep(rows, source, folder, context);
  make_output_folder("the parts of the table", folder / "parts");
  SweepResult result;
  result.rows = rows.count();
  result.parts = rows.part_count();
  const auto is_made = [&](std::uint64_t part) {
    return is_whole_part(part_file(folder, part), rows.rows_of(part));
  };
  std::vector<std::uint64_t> wanted;
  for (std::uint64_t part = 0; part < result.parts; ++part) {
    if (shard.has(part) && !is_made(part)) wanted.push_back(part);
  }
  const auto share = 1 / static_cast<double>(wanted.size());
  for (const std::uint64_t part : wanted) {
    const auto before = static_cast<double>(result.parts_made);
    const Context own = phase_part(context, "sweep", before * share, (before + 1) * share);
    const fs::path file = part_file(folder, part);
    const std::uint64_t begin = part * rows.rows_of_part(), count = rows.rows_of(part);
    std::string lines = whole_lines(file);  // of a smaller table, which ended there
    if (line_count(lines) >= count) lines.clear();
    lines += make_rows(rows, begin + line_count(lines), begin + count, source.folder.string(), own);
    check_claim(folder, source);
    write_file(file, with_mark(lines, count), "cannot write a part of the table", context);
    ++result.parts_made;
  }
  if (!wanted.empty()) context.report({"sweep", 1});
  for (std::uint64_t part = 0; part < result.parts; ++part) {
    if (!is_made(part)) ++result.parts_left;
  }
  check_claim(folder, source);
  if (result.parts_left > 0) return result;
  if (const FailedRows failed = join_parts(rows, folder, context); failed.count > 0) {
    result.warnings.push_back(
        fmt::format("{} of {} rows could not be done (status in table.csv), first row {}: {}; to "
                    "have such rows run again, remove the parts that hold them, first {}",
                    failed.count, result.rows, failed.first, failed.why,
                    part_file(folder, failed.part).string()));
  }
  return result;
}

}  // namespace craze
