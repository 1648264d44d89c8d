// Coordinates for formats that hold only floats.
#pragma once

#include <array>
#include <string>

#include "craze/surface_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// The nearest floats. Throws Error(request), naming the format, for a coordinate that is not
/// finite in single precision.
std::array<float, 3> to_floats(const Vec3& p, const char* format);

/// What single precision does to a mesh far from the origin, measured, as a part of a sentence;
/// empty where no vertex moves by more than 10⁻⁶ of the mesh's size.
std::string describe_precision_loss(const SurfaceMesh& mesh);

}  // namespace craze
