// A crack pattern from a file, to be measured.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "craze/products/statistics/graph/graph_input.h"

namespace craze {

/// A file of lines (see io/read_lines.h) or a cracked mesh, or "null:NAME?cells=N&seed=S" (see
/// null_models.h). Throws Error(input) where it cannot be read, Error(request) where it holds no
/// cracks. What reading a mesh left out is added to `warnings`.
CrackGraphInput graph_from_file(const std::filesystem::path& path,
                                std::vector<std::string>& warnings);

}  // namespace craze
