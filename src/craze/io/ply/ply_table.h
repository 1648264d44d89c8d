// The rows of a PLY file's elements as columns of numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "craze/base/progress_meter.h"
#include "craze/io/bytes/text_cursor.h"
#include "craze/io/mesh_source.h"
#include "craze/io/ply/ply_header.h"

namespace craze {

/// One property of every row of an element.
struct PlyColumn {
  std::vector<double> values;     ///< one per row, or the items of all lists in a row's order
  std::vector<std::size_t> ends;  ///< of a list, per row: one past its last item in values
};

/// Reads the elements' rows one element after another, in the header's order.
class PlyBody {
 public:
  /// Both must outlive the reader.
  PlyBody(const MeshSource& source, const PlyHeader& header);

  /// The next element's columns, one per property. Throws Error(input) where the file is too short
  /// for the rows it promises, before anything is allocated for them.
  std::vector<PlyColumn> read(const PlyElement& element);

  /// Rows so far of an ascii file whose lines hold more numbers than the header declares.
  std::size_t surplus_rows() const { return surplus_rows_; }

  /// Bytes after the rows read so far that say something.
  std::size_t unread();

 private:
  void read_ascii(const PlyElement& element, std::vector<PlyColumn>& columns);
  void read_fixed(const PlyElement& element, std::vector<PlyColumn>& columns);
  void read_lists(const PlyElement& element, std::vector<PlyColumn>& columns);
  double next(PlyType type);
  void skip_surplus();
  [[noreturn]] void fail_short(const PlyElement& element) const;

  const PlyHeader& header_;
  const std::string& name_;
  std::size_t size_;  ///< of the whole file
  ProgressMeter meter_;
  std::string_view rest_;             ///< of a binary file
  TextCursor text_, text_at_start_;   ///< of an ascii file
  std::optional<bool> line_per_row_;  ///< once it matters
  std::size_t surplus_rows_ = 0;
};

}  // namespace craze
