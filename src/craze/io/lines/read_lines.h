// Crack lines or a skeleton from a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "craze/mesh/line_set.h"

namespace craze {

/// Lines from .obj (`l`), .ply (an element `edge` with vertex1 and vertex2) or .json. None where
/// the file is of another format or holds no lines: it may be a mesh. Indices are in range and
/// coordinates finite. Throws Error(input).
///
/// PLY: nx ny nz become the point attribute "normal"; other scalars keep their names.
/// JSON: {"points": [[x, y, z] or [x, y], …], "edges": [[a, b], …], "point_attributes": {NAME:
/// [one number or one array of numbers per point]}, "edge_attributes": {likewise}}.
std::optional<LineSet> read_lines(const std::filesystem::path& path);

/// The same from a file's bytes; `extension` in lower case with its dot, `name` for messages.
std::optional<LineSet> parse_lines(std::string_view bytes, const std::string& extension,
                                   const std::string& name);

}  // namespace craze
