// Where each element of a surface made from another one came from.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// An element of the new surface is the mean of two of the old one, mostly twice the same.
struct SurfaceSource {
  std::vector<std::array<std::int32_t, 2>> vertices;  ///< #V: old vertices
  std::vector<std::array<std::int32_t, 2>> corners;   ///< 3 #F: old corners 3f+i
  std::vector<std::int32_t> faces;                    ///< #F: old faces
  std::vector<char> flipped;                          ///< #F: oriented against the old face
};

/// The new surface: its triangles with positions and every attribute taken from the old one.
/// Corner normals of a flipped face that point against it are reversed.
SurfaceMesh transfer(const SurfaceMesh& old, std::vector<Triangle> triangles,
                     const SurfaceSource& source);

}  // namespace craze
