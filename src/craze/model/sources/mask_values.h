// What of a surface may serve as a mask: for [where], and for looking at it and painting over it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "craze/grey_image.h"
#include "craze/surface_mesh.h"

namespace craze {

/// In 0 … 1 but for rounding, which is cut off. Throws Error(request), naming where.attribute and
/// the first that is beyond: `element` is "vertex" or "face".
std::vector<double> mask_shares(std::vector<double> values, const char* element);

/// The vertex attributes that where.attribute takes: scalars in 0 … 1, those of vertex colours
/// ("color", "color_r" …) too.
std::vector<std::string> mask_names(const SurfaceMesh& surface);

/// #V, one of them, 0 … 1. Throws Error(request) for any other name.
std::vector<double> mask_at_vertices(const SurfaceMesh& surface, const std::string& name);

/// Sets, at the vertices of the faces of one material, the mean of the picture at the UVs that each
/// has in their corners; the rest of `values`, #V, stays. `place`: from (u, v, 1) of the mesh to
/// the picture's (u, v). Throws Error(request) where the surface has no UVs.
void set_mask_from_picture(const SurfaceMesh& surface, std::int32_t material,
                           const GreyImage& picture, const Eigen::Matrix<double, 2, 3>& place,
                           double* values);

}  // namespace craze
