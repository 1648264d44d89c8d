// The files beside a file that it may open.
#pragma once

#include <filesystem>
#include <string>

#include "craze/context.h"
#include "craze/io/mesh_source.h"

namespace craze {

/// The path that a URI names: %XX are bytes; a % without two hexadecimal digits stays.
std::string decode_percent(const std::string& uri);

/// A loader of files in one folder or below it. Refuses absolute paths, `..`, URIs with a scheme
/// and links that lead outside. `context` must outlive it.
FileLoader load_from_folder(const std::filesystem::path& folder, const Context& context);

}  // namespace craze
