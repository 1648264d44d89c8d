// A picture of all directions from its file.
#pragma once

#include <memory>
#include <string>

#include "craze/context.h"
#include "craze/render/light/environment.h"

namespace craze::render {

/// Of a Radiance picture (.hdr), or of a PNG or JPEG, whose sRGB has no lamps brighter than white;
/// told by content. Throws Error(input) where it cannot be read, what Environment throws with the
/// path in place of its name, and Cancelled.
std::shared_ptr<const Environment> read_environment(const std::string& path,
                                                    const Context& context);

}  // namespace craze::render
