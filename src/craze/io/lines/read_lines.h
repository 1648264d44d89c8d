// Crack lines or a skeleton from bytes, or from a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "craze/context.h"
#include "craze/line_set.h"

namespace craze {

/// Lines from .obj (`l`), .ply (an element `edge` with vertex1 and vertex2) or .json, by the
/// extension of `name`, which also stands for the file in messages. None where the bytes are of
/// another format or hold no lines: they may be a mesh. Indices are in range and coordinates
/// finite. Throws Error(input), and Cancelled.
///
/// PLY: nx ny nz become the point attribute "normal"; other scalars keep their names.
/// JSON: {"points": [[x, y, z] or [x, y], …], "edges": [[a, b], …], "point_attributes": {NAME:
/// [one number or one array of numbers per point]}, "edge_attributes": {likewise}}.
std::optional<LineSet> read_lines(std::string_view bytes, const std::string& name,
                                  const Context& context = {});

/// The same from a file.
std::optional<LineSet> read_lines_file(const std::filesystem::path& path,
                                       const Context& context = {});

}  // namespace craze
