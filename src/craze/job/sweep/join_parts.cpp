#include "craze/job/sweep/join_parts.h"

#include <fmt/format.h>

#include <cstring>
#include <limits>
#include <vector>

#include "craze/base/parse_double.h"
#include "craze/error.h"
#include "craze/io/files/new_file.h"
#include "craze/io/files/read_file.h"
#include "craze/io/image/deflate.h"
#include "craze/job/sweep/sweep_table.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

constexpr const char* failure = "cannot write the table";
constexpr std::size_t text_width = 96;  // bytes of a text in table.npy; longer ones are cut

/// The lines of a part without its mark.
std::string_view without_mark(std::string_view text) {
  const auto mark = text.rfind("\n#");
  return mark == std::string_view::npos ? std::string_view() : text.substr(0, mark + 1);
}

/// NumPy's format, version 1.0: a header that ends at a multiple of 64 bytes, then the records.
std::string npy_header(const std::vector<SweepColumn>& columns, std::uint64_t rows) {
  std::string law = "{'descr': [";
  for (const SweepColumn& c : columns) {
    law += fmt::format("('{}', '{}'), ", c.name, c.text ? fmt::format("|S{}", text_width) : "<f8");
  }
  law += fmt::format("], 'fortran_order': False, 'shape': ({},), }}", rows);
  constexpr std::size_t before = 10, block = 64;
  law.append(block - (before + law.size() + 1) % block, ' ');
  law += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(law.size() & 255);
  header += static_cast<char>(law.size() >> 8);
  return header + law;
}

void append_record(std::string& bytes, const std::vector<SweepColumn>& columns,
                   std::string_view line) {
  const std::vector<std::string> cells = csv_cells(line);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string cell = i < cells.size() ? cells[i] : "";
    if (columns[i].text) {
      std::string text = cell.substr(0, text_width);
      text.resize(text_width, '\0');
      bytes += text;
      continue;
    }
    double x = std::numeric_limits<double>::quiet_NaN();
    if (!cell.empty()) parse_double(cell.data(), cell.data() + cell.size(), x);
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    for (int k = 0; k < 8; ++k) bytes += static_cast<char>(bits >> (8 * k) & 255);
  }
}

}  // namespace

fs::path part_file(const fs::path& folder, std::uint64_t part) {
  return folder / "parts" / fmt::format("{:06}.csv", part);
}

std::string with_mark(std::string_view lines, std::uint64_t count) {
  return fmt::format("{}# whole: {} rows, crc {:08x}\n", lines, count, crc(lines));
}

bool is_whole_part(const fs::path& file, std::uint64_t count) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return false;
  const std::string text = read_file(file, "cannot read a part of the table");
  const std::string_view lines = without_mark(text);
  return !lines.empty() && text == with_mark(lines, count);
}

void join_parts(const SweepRows& rows, const fs::path& folder, const Context& context) {
  const std::vector<SweepColumn> columns = sweep_columns(rows);
  NewFile csv(folder / "table.csv", failure, context), npy(folder / "table.npy", failure, context);
  std::string head;
  for (const SweepColumn& c : columns) head += (head.empty() ? "" : ",") + c.name;
  csv.append(head + "\n");
  npy.append(npy_header(columns, rows.count()));
  for (std::uint64_t part = 0; part < rows.part_count(); ++part) {
    const std::string text =
        read_file(part_file(folder, part), "cannot read a part of the table", context);
    const std::string_view lines = without_mark(text);
    csv.append(lines);
    std::string records;
    for (std::size_t at = 0; at < lines.size();) {
      const std::size_t end = lines.find('\n', at);
      append_record(records, columns, lines.substr(at, end - at));
      at = end + 1;
    }
    npy.append(records);
  }
  csv.finish();
  npy.finish();
}

}  // namespace craze
