// Folders that outputs go to.
#pragma once

#include <filesystem>

namespace craze {

/// Refuses a folder that cannot be made or written: Error(output) "cannot write WHAT (FOLDER):
/// WHY".
void check_output_folder(const char* what, const std::filesystem::path& folder);

/// Makes it and what is missing above it; Error(output).
void make_output_folder(const char* what, const std::filesystem::path& folder);

}  // namespace craze
