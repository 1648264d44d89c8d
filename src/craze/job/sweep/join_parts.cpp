#include "craze/job/sweep/join_parts.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "craze/base/parse_double.h"
#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/bytes/crc32.h"
#include "craze/io/files/new_file.h"
#include "craze/io/files/read_file.h"
#include "craze/job/output_folder.h"
#include "craze/job/sweep/sweep_plots.h"
#include "craze/job/sweep/sweep_table.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

constexpr const char* failure = "cannot write the table";
constexpr std::size_t text_width = 96;  // bytes of a text in a column; longer ones are cut

/// The lines of a part without its mark.
std::string_view without_mark(std::string_view text) {
  const auto mark = text.rfind("\n#");
  return mark == std::string_view::npos ? std::string_view() : text.substr(0, mark + 1);
}

/// A column as NumPy's format has it, version 1.0: a header that ends at a multiple of 64 bytes,
/// then the values.
class ColumnFile {
 public:
  ColumnFile(const SweepColumn& column, const fs::path& folder, std::uint64_t rows,
             const Context& context)
      : text_(column.text),
        file_(std::make_unique<NewFile>(folder / (column.name + ".npy"), failure, context)) {
    std::string law = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({},), }}",
                                  text_ ? fmt::format("|S{}", text_width) : "<f8", rows);
    constexpr std::size_t before = 10, block = 64;
    law.append(block - (before + law.size() + 1) % block, ' ');
    law += '\n';
    values_.assign("\x93NUMPY\x01\x00", 8);
    values_ += static_cast<char>(law.size() & 255);
    values_ += static_cast<char>(law.size() >> 8);
    values_ += law;
  }

  void add(const std::string& cell) {
    if (text_) {
      std::string text = cell.substr(0, text_width);
      text.resize(text_width, '\0');
      values_ += text;
      return;
    }
    double x = std::numeric_limits<double>::quiet_NaN();
    if (!cell.empty()) parse_double(cell.data(), cell.data() + cell.size(), x);
    append(values_, x);
  }
  /// What has been added goes to the file.
  void flush() {
    file_->append(values_);
    values_.clear();
  }
  void finish() {
    flush();
    file_->finish();
  }

 private:
  bool text_;
  std::string values_;
  std::unique_ptr<NewFile> file_;
};

}  // namespace

fs::path part_file(const fs::path& folder, std::uint64_t part) {
  return folder / "parts" / fmt::format("{:06}.csv", part);
}

std::string with_mark(std::string_view lines, std::uint64_t count) {
  return fmt::format("{}# whole: {} rows, crc {:08x}\n", lines, count, crc32(lines));
}

bool is_whole_part(const fs::path& file, std::uint64_t count) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return false;
  const std::string text = read_file(file, "cannot read a part of the table");
  const std::string_view lines = without_mark(text);
  return !lines.empty() && text == with_mark(lines, count);
}

std::string whole_lines(const fs::path& file) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return "";
  std::string text = read_file(file, "cannot read a part of the table");
  const std::string_view lines = without_mark(text);
  const auto count = static_cast<std::uint64_t>(std::count(lines.begin(), lines.end(), '\n'));
  if (text != with_mark(lines, count)) return "";
  text.resize(lines.size());
  return text;
}

FailedRows join_parts(const SweepRows& rows, const fs::path& folder, const Context& context) {
  const std::vector<SweepColumn> columns = sweep_columns(rows);
  const auto status = static_cast<std::size_t>(
      std::find_if(columns.begin(), columns.end(),
                   [](const SweepColumn& column) { return column.name == "status"; }) -
      columns.begin());
  FailedRows rows_that_failed;
  make_output_folder("the columns of the table", folder / "columns");
  std::vector<ColumnFile> files;
  NewFile csv(folder / "table.csv", failure, context);
  std::string head;
  for (const SweepColumn& c : columns) {
    files.emplace_back(c, folder / "columns", rows.count(), context);
    head += (head.empty() ? "" : ",") + c.name;
  }
  csv.append(head + "\n");
  SweepPlots plots(rows);
  for (std::uint64_t part = 0; part < rows.part_count(); ++part) {
    const std::string text =
        read_file(part_file(folder, part), "cannot read a part of the table", context);
    const std::string_view lines = without_mark(text);
    csv.append(lines);
    for (std::size_t at = 0; at < lines.size();) {
      const std::size_t end = lines.find('\n', at);
      std::vector<std::string> cells = csv_cells(lines.substr(at, end - at));
      cells.resize(columns.size());
      for (std::size_t i = 0; i < cells.size(); ++i) files[i].add(cells[i]);
      plots.add(cells);
      if (cells[status] != "ok" && rows_that_failed.count++ == 0) {
        rows_that_failed.first = cells.front();
        rows_that_failed.why = cells[status];
        rows_that_failed.part = part;
      }
      at = end + 1;
    }
    for (ColumnFile& file : files) file.flush();
  }
  // Where table.csv is, the rest is that of its rows.
  std::error_code failed;
  if (fs::file_size(folder / "table.csv", failed) != csv.size() && !failed) {
    fs::remove(folder / "table.csv", failed);
  }
  plots.write(folder / "plots", context);
  for (ColumnFile& file : files) file.finish();
  csv.finish();
  return rows_that_failed;
}

}  // namespace craze
