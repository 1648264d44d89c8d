// Curvature tensors of a triangle mesh by normal cycles [CSM03, see normal_cycle.h].
//
// Sign: positive where the surface is convex seen from outside (the side its normals point to), so
// that a sphere of radius R has κ₁ = κ₂ = 1/R. Borders add nothing.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/parameters.h"
#include "craze/tensor.h"

namespace craze {

/// Principal curvatures (1/length) and their unit directions, tangent to the surface.
struct PrincipalCurvature {
  double k1 = 0, k2 = 0;  ///< k1 ≥ k2
  Vec3 direction1 = Vec3::UnitX(), direction2 = Vec3::UnitY();

  double gaussian() const { return k1 * k2; }
  double mean() const { return 0.5 * (k1 + k2); }
  double sum_of_squares() const { return k1 * k1 + k2 * k2; }
  double frobenius() const { return std::sqrt(sum_of_squares()); }
};

/// The radius used where 0 is given: twice the mean edge length.
double default_curvature_radius(const TriangleMesh& mesh);

/// #F curvature tensors, 1/length, in each face's tangent_frame. Averages over the surface within
/// about `radius` of the face's centroid (a disc of that radius has the same second moment as the
/// smooth weight used); 0: default_curvature_radius. Detail smaller than the radius is smoothed
/// away, noise of single vertices with it. Cost: #F times the faces in a neighbourhood; throws
/// Error(request) before it starts where that is more than 10¹⁰, and Cancelled.
std::vector<Sym2> face_curvature(const TriangleMesh& mesh, double radius, const Context& context);

/// #V, the same around each vertex. A vertex without faces gets zeros.
std::vector<PrincipalCurvature> vertex_curvature(const TriangleMesh& mesh, double radius,
                                                 const Context& context);

/// Eigenvalues and world eigenvectors of a tensor given in a face's frame.
PrincipalCurvature principal_curvature(const Sym2& tensor, const Mat32& frame);

/// #V factors for the separation tensor: the measure that `scale` names, taken absolutely and
/// divided by its mean over the vertices, so that the mean factor is 1 and neither the unit of
/// length nor the size of the object matters. All 1 for CurvatureScale::none, and where the surface
/// is flat everywhere.
std::vector<double> curvature_factors(std::span<const PrincipalCurvature> curvature,
                                      CurvatureScale scale);

}  // namespace craze
