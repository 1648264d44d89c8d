// Writes the scalar properties of one element of a PLY file.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// Each property has a name, a type and a way to append a row's value. What is passed by reference
/// must outlive the list.
class PlyProperties {
 public:
  /// `reserved`: names the element already has.
  explicit PlyProperties(std::set<std::string> reserved = {}) : names_(std::move(reserved)) {}

  /// Names are made words of letters, digits and `_` that no other property has.
  void add(const std::string& name, const char* type,
           std::function<void(std::string&, std::size_t)> append_row);
  void add_double(const std::string& name, std::function<double(std::size_t)> value);
  /// `row` maps a written row to the attribute's; empty: the same.
  void add_attribute(const Attribute& attribute,
                     const std::function<std::size_t(std::size_t)>& row = nullptr);

  /// The header's property lines.
  const std::string& header() const { return header_; }
  void append_row(std::string& bytes, std::size_t row) const;

 private:
  std::string unique(std::string name);

  std::set<std::string> names_;
  std::string header_;
  std::vector<std::function<void(std::string&, std::size_t)>> appenders_;
};

}  // namespace craze
