// A folder of meshes that samples draw from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace craze {

/// The mesh files in a folder, in the order of their names; not those in folders in it, nor pipes.
/// Throws Error(input) where it has none.
std::vector<std::string> meshes_in(const std::filesystem::path& folder);

}  // namespace craze
