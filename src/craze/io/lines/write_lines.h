// Lines to bytes, or to a file.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "craze/context.h"
#include "craze/line_set.h"

namespace craze {

/// Told, in one sentence each, what the format cannot hold; may be empty.
using LinesWarning = std::function<void(const std::string&)>;

/// The bytes of a file of that format: "ply" (vertices and an `edge` element with all attributes),
/// "obj" (polylines), "svg" or "json". Throws Error(usage) for another format, Error(request) where
/// it cannot hold the lines.
std::string format_lines(const LineSet& lines, std::string_view format,
                         const LinesWarning& warn = {});

/// Writes the format of the path's extension, whole or not at all. Throws as format_lines does,
/// Error(output) where the file cannot be written, and Cancelled.
void write_lines(const std::filesystem::path& path, const LineSet& lines,
                 const LinesWarning& warn = {}, const Context& context = {});

/// Binary little-endian PLY: `vertex` x y z and `edge` vertex1 vertex2, attributes as doubles
/// (several components: NAME_0 NAME_1 …), UVs as edge properties s1 t1 s2 t2.
std::string format_lines_ply(const LineSet& lines);

/// OBJ with `v` and one `l` per polyline. Attributes and UVs have no place.
std::string format_lines_obj(const LineSet& lines);

/// {"points": [[x, y, z] …], "edges": [[a, b] …], "uvs": [[[u, v], [u, v]] …],
/// "point_attributes": {NAME: [value or [values] …]}, "edge_attributes": {…}}; empty parts are left
/// out but points and edges.
std::string format_lines_json(const LineSet& lines);

/// SVG, the longer side 1024 pixels: in the UVs where the lines have them, the unit square in the
/// view and a path per island (uv_lines.h), else on their plane. Warns of edges that have no UVs
/// beside others that have. Throws Error(request) for lines without UVs that leave their best-fit
/// plane by more than 10⁻⁶ of their size.
std::string format_lines_svg(const LineSet& lines, const LinesWarning& warn = {});

/// The lines as chains of point indices that use every edge once: from ends and junctions first,
/// closed loops (first point repeated at the end) after; starts in the order of the points.
std::vector<std::vector<std::int32_t>> join_edges(const LineSet& lines);

}  // namespace craze
