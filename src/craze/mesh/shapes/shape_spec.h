// The text form of a shape: a name and its numbers.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "craze/shapes.h"

namespace craze {

/// A parsed specification: every parameter of the shape has a value.
struct ShapeSpec {
  const ShapeInfo* shape;
  std::map<std::string_view, double> values;

  double operator[](std::string_view name) const { return values.at(name); }
  int integer(std::string_view name) const { return static_cast<int>(values.at(name)); }
};

/// Parses `name?key=value&key=value` against the table. Throws Error(usage) as make_shape() says.
ShapeSpec parse_shape(std::string_view specification);

}  // namespace craze
