#include "craze/job/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "craze/base/progress_meter.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/job/output_folder.h"
#include "craze/job/plan/side_by_side.h"
#include "craze/job/sweep/join_parts.h"
#include "craze/job/sweep/sweep_table.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

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

}  // namespace

SweepResult run_sweep(const PlanSource& source, const fs::path& folder, Shard shard,
                      const Context& context) {
  const SweepRows rows(Plan(source.text, source.name, sweep_schema()));
  claim_plan_folder(folder, source, "sweep", context);
  make_output_folder("the parts of the table", folder / "parts");
  SweepResult result{rows.count(), rows.part_count()};
  const auto begin_of = [&](std::uint64_t part) {
    return std::min(rows.count(), part * rows.rows_of_part());
  };
  const auto is_made = [&](std::uint64_t part) {
    return is_whole_part(part_file(folder, part), begin_of(part + 1) - begin_of(part));
  };
  std::vector<std::uint64_t> wanted;
  for (std::uint64_t part = 0; part < result.parts; ++part) {
    if (shard.has(part) && !is_made(part)) wanted.push_back(part);
  }
  const auto share = 1 / static_cast<double>(wanted.size());
  for (const std::uint64_t part : wanted) {
    const auto before = static_cast<double>(result.parts_made);
    const Context own = phase_part(context, "sweep", before * share, (before + 1) * share);
    const std::uint64_t begin = begin_of(part), end = begin_of(part + 1);
    const std::string text = make_rows(rows, begin, end, source.folder.string(), own);
    write_file(part_file(folder, part), with_mark(text, end - begin),
               "cannot write a part of the table", context);
    ++result.parts_made;
  }
  if (!wanted.empty()) context.report({"sweep", 1});
  for (std::uint64_t part = 0; part < result.parts; ++part) {
    if (!is_made(part)) ++result.parts_left;
  }
  if (result.parts_left == 0) join_parts(rows, folder, context);
  return result;
}

}  // namespace craze
