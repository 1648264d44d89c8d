// The attributes that every run adds to its mesh, in place of older ones of these names.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace craze {

/// Of vertices and of faces; what they are: products/cut_surface.h.
inline bool is_run_attribute(std::string_view name) {
  constexpr std::array<std::string_view, 7> names{"crack_distance", "crack_time", "crack_growth",
                                                  "displacement",   "openness",   "fragment",
                                                  "source_face"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace craze
