// An element's columns by name.
#pragma once

#include <string>
#include <vector>

#include "craze/io/mesh_source.h"
#include "craze/io/ply/ply_table.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Columns are taken by name; what is left at the end becomes attributes.
class PlyRows {
 public:
  /// `element` and `name`, the file's, must outlive this. Throws Error(input), naming the row, for
  /// a place or an index that is not finite; any other value that is not becomes 0.
  PlyRows(const PlyElement& element, std::vector<PlyColumn> columns, const std::string& name);

  std::size_t count() const { return element_.count; }
  bool has(const std::string& property, bool list = false) const {
    return find(property, list) >= 0;
  }
  bool has_all(const std::vector<std::string>& properties) const;

  /// These ask for a property that has() is true for.
  PlyType type(const std::string& property) const;
  const std::vector<double>& take(const std::string& property);
  const PlyColumn& take_list(const std::string& property);

  /// Names, in one sentence, the values that were made 0.
  void warn_of_mended(const MeshSource& source) const;
  /// The names of the lists not taken.
  std::vector<std::string> lists_left() const;
  /// The scalars not taken, NAME_0 NAME_1 … as one.
  std::vector<Attribute> attributes() const;

 private:
  std::ptrdiff_t find(const std::string& property, bool list = false) const;
  bool is_spare(std::size_t i) const { return !taken_[i] && !element_.properties[i].is_list; }
  std::size_t components_from(std::size_t first, const std::string& stem) const;
  [[noreturn]] void fail_value(std::size_t column, std::size_t k) const;

  const PlyElement& element_;
  std::vector<PlyColumn> columns_;
  std::vector<bool> taken_;
  std::vector<std::size_t> mended_;  ///< per column: values that were not finite
  const std::string& name_;
};

}  // namespace craze
