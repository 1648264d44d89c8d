// Surfaces made from a few numbers: what `shape:NAME?key=value&…` stands for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

/// One number that a shape takes.
struct ShapeParameter {
  std::string_view name;
  double standard;  ///< used when the specification does not give it
  double low, high;
  bool integer;
  std::string_view text;
};

/// A shape and what it can be asked.
struct ShapeInfo {
  std::string_view name;
  std::string_view text;
  std::vector<ShapeParameter> parameters;
};

/// Every shape: the one table that parsing, messages and help read.
const std::vector<ShapeInfo>& shape_table();

/// The table as text, a line per shape and an indented one per parameter.
std::string shape_help();

/// Makes the shape of a specification like `plate?n=99&jitter=0.3` (no `shape:` in front). The
/// surface is manifold and consistently oriented: outward where it is closed, towards +z where it
/// is flat. Solids have their axis along z; every shape but `cup`, `bowl` and `drape` (which stand
/// on z = 0) is centred at the origin. UVs lie in 0 … 1 and do not overlap; round shapes carry the
/// corner normals of the smooth surface. Throws Error(usage) for an unknown name or key, a value
/// that is not a number or out of range, and Cancelled.
SurfaceMesh make_shape(std::string_view specification, const Context& context = {});

}  // namespace craze
