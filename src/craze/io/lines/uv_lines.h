// Lines as they run in a texture.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/line_set.h"

namespace craze {

struct UvLines {
  LineSet lines;                     ///< points (u, v, 0), joined where the UVs of their ends agree
  std::vector<std::int32_t> island;  ///< #P of lines: the island that a point lies in
  std::size_t left_out = 0;          ///< edges without a place in the texture
};

/// Lines with UVs, drawn in the texture: points split where a seam parts them. Islands are those of
/// the edge attribute "uv_island"; without it all edges are of island 0. Left out are edges of
/// island −1 and those that have a length but none in the texture: of parts without UVs.
UvLines uv_lines(const LineSet& lines);

}  // namespace craze
