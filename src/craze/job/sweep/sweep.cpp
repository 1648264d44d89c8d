#include "craze/job/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

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
    context.report(
        {"sweep", static_cast<double>(first + lines.size()) / static_cast<double>(rows.count())});
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
  for (std::uint64_t part = 0; part < result.parts; ++part) {
    const fs::path file = part_file(folder, part);
    const std::uint64_t begin = part * rows.rows_of_part();
    const std::uint64_t end = std::min(rows.count(), begin + rows.rows_of_part());
    if (!shard.has(part) || is_whole_part(file, end - begin)) continue;
    const std::string text = make_rows(rows, begin, end, source.folder.string(), context);
    write_file(file, with_mark(text, end - begin), "cannot write a part of the table", context);
    ++result.parts_made;
  }
  for (std::uint64_t part = 0; part < result.parts; ++part) {
    const std::uint64_t begin = part * rows.rows_of_part();
    const std::uint64_t length = std::min(rows.count() - begin, rows.rows_of_part());
    if (!is_whole_part(part_file(folder, part), length)) ++result.parts_left;
  }
  if (result.parts_left == 0) join_parts(rows, folder, context);
  return result;
}

}  // namespace craze
