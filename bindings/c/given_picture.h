// Pictures that callers hand over.
#pragma once

#include "craze/craze.h"
#include "craze/grey_image.h"

namespace craze::c {

/// `pixels` as craze_job_set_texture takes them. Throws Error(usage), with `name`, for what is not
/// such a picture.
GreyImage grey_picture(const void* pixels, craze_type type, int64_t width, int64_t height,
                       int32_t channels, const char* name);

}  // namespace craze::c
