// Triangles that suit the growth of cracks: of one size, without grain, on the same surface.
#pragma once

#include <cstdint>

#include "craze/base/period.h"
#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

struct RemeshOptions {
  double target_edge = 0;     ///< mean edge length asked for, model units, > 0
  double max_distance = 0;    ///< from the input surface, model units; 0: a tenth of target_edge
  double feature_angle = 40;  ///< degrees: sharper folds are kept as lines
  /// false: where the input is finer than target_edge the result is as fine as the input, so that
  /// no modelled detail goes; only slivers and grain do. true: fine parts are coarsened as well, as
  /// far as max_distance allows.
  bool coarsen = false;
  int iterations = 5;      ///< rounds of edits and smoothing; more give more even triangles
  std::uint64_t seed = 1;  ///< of the irregularity
  /// Of the input, which is then a plane without attributes, and so is what comes of it.
  Period period;
};

/// Incremental isotropic remeshing after Botsch & Kobbelt (A Remeshing Approach to Multiresolution
/// Modeling, SGP 2004): split edges above 4/3 of the length wanted there, collapse those below 4/5,
/// flip towards Delaunay, smooth within the surface, project back onto the input. The length wanted
/// varies by a seeded ±15 % from vertex to vertex and vertices are shaken once, so a regular input
/// loses its rows and diagonals.
///
/// Borders, folds sharper than feature_angle, UV seams and borders of materials remain lines:
/// vertices are put on them, never beside them; a seam keeps its exact course, the others within
/// max_distance. The middle of every edge and face lies
/// within max_distance of the input, but for places where the input folds back on itself within an
/// edge. Creases shorter than a few edges are taken for noise.
///
/// UVs, normals, colours and vertex attributes are interpolated at the nearest point of the input,
/// on the side of a seam on which the face lies; materials, face attributes and source_faces (the
/// input's, or the input triangle's number where it has none) come from the nearest input triangle.
///
/// The input must suit the constructor of TriangleMesh (see repair.h); so does the result. Throws
/// Error(request) for a target that would give more than 50 million triangles or is not positive.
/// Throws Cancelled. The same on any number of threads.
SurfaceMesh remesh(const SurfaceMesh& input, const RemeshOptions& options, const Context& context);

}  // namespace craze
