// Other numbers for the vertices and faces of a mesh, and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// Of each vertex and face, by its new number, what number it had. What was added to a mesh later
/// (numbers from there on) keeps its number.
struct Numbering {
  std::vector<std::int32_t> vertices;  ///< #V, a permutation
  std::vector<std::int32_t> faces;     ///< #F, a permutation

  bool empty() const { return vertices.empty() && faces.empty(); }
};

/// Of each old number, what is the new one.
std::vector<std::int32_t> inverse(const std::vector<std::int32_t>& permutation);

/// The numbering that leads back.
Numbering inverse(const Numbering& numbering);

/// Gives everything in `surface` its new number. Corners stay in their order.
void renumber(SurfaceMesh& surface, const Numbering& numbering);

/// values[i] becomes what was values[was[i]]; `stride` values lie together, and those after the
/// numbered ones stay.
template <class Values>
void reorder(Values& values, const std::vector<std::int32_t>& was, std::size_t stride = 1) {
  if (values.empty()) return;
  Values ordered;
  ordered.reserve(values.size());
  for (const std::int32_t i : was) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(stride) * i;
    ordered.insert(ordered.end(), first, first + static_cast<std::ptrdiff_t>(stride));
  }
  ordered.insert(ordered.end(), values.begin() + static_cast<std::ptrdiff_t>(stride * was.size()),
                 values.end());
  values = std::move(ordered);
}

/// The new number of what was `number`: `now` is the inverse; what is none, or added, stays.
inline std::int32_t new_number(const std::vector<std::int32_t>& now, std::int32_t number) {
  return number >= 0 && number < static_cast<std::int32_t>(now.size()) ? now[number] : number;
}

}  // namespace craze
