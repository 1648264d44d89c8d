// What of a mesh a picture is of.
#pragma once

#include <vector>

#include "craze/surface_mesh.h"

namespace craze::render {

/// What the camera frames and sizes are measured by.
struct Subject {
  std::vector<Vec3> points;  ///< the vertices that are to be seen, model units
  /// The mean of the triangles' unit normals, by area: zero for a closed surface, a unit vector for
  /// a flat sheet.
  Vec3 facing = Vec3::Zero();
};

/// The mesh without its strays: parts of less than a hundredth of the area together that lie
/// farther from all others than a tenth of their diagonal. Faces that share a vertex, or vertices
/// at one place, are of one part. Vertices without triangles do not count.
Subject subject_of(const SurfaceMesh& mesh);

}  // namespace craze::render
