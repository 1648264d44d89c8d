// The container of a GLB file.
#pragma once

#include <string>

namespace craze {

/// The file of a document and its buffer's bytes; without bytes it has no second chunk. Throws
/// Error(request) for more than 4 GB.
std::string glb_file(std::string json, const std::string& bin);

}  // namespace craze
