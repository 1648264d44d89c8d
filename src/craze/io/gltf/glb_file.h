// The container of a GLB file.
#pragma once

#include <span>
#include <string>

#include "craze/io/bytes/byte_sink.h"

namespace craze {

/// The file of a document and its buffer's bytes; without bytes it has no second chunk. Throws
/// Error(request) for more than 4 GB.
std::string glb_file(std::string json, const std::string& bin);
/// The same, passed on, the bytes in parts.
void write_glb_file(std::string json, std::span<const std::string> bin, ByteSink& sink);

}  // namespace craze
