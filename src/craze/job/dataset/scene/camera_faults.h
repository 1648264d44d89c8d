// What a camera does to a picture: blur, shake, noise, packing.
#pragma once

#include <cstdint>

#include "craze/job/plan/plan.h"
#include "craze/render/image.h"

namespace craze {

/// In the order of a camera: lens blur and shake, then the sensor's noise, then JPEG. The same
/// bytes on every machine but for JPEG, which is libjpeg's own. Where the build lacks JPEG, throws
/// Error(request) for a quality below 100.
render::Image with_camera_faults(const render::Image& image, const PlanValues& values,
                                 std::uint64_t seed);

}  // namespace craze
