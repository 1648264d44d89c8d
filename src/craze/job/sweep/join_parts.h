// The parts of a sweep's table, and the table.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "craze/context.h"
#include "craze/job/sweep/sweep_rows.h"

namespace craze {

std::filesystem::path part_file(const std::filesystem::path& folder, std::uint64_t part);

/// A part's lines with a last one that says how many they are and their checksum.
std::string with_mark(std::string_view lines, std::uint64_t count);

/// Whether the file is there and its last line says that it is whole, with so many rows.
bool is_whole_part(const std::filesystem::path& file, std::uint64_t count);

/// The lines of a part without its mark, where that says that they are whole, however many; else
/// "".
std::string whole_lines(const std::filesystem::path& file);

/// Rows of a table whose runs could not be done.
struct FailedRows {
  std::uint64_t count = 0;
  std::string first, why;  ///< the number of the first one and its status
  std::uint64_t part = 0;  ///< that it is in
};

/// table.csv, columns/NAME.npy and plots/ of all parts, which must be whole, a part in memory at a
/// time. Each file is whole or not there, table.csv the last; one of fewer rows is removed before
/// the others are replaced. Throws Error(output), Error(input) and Cancelled.
FailedRows join_parts(const SweepRows& rows, const std::filesystem::path& folder,
                      const Context& context);

}  // namespace craze
