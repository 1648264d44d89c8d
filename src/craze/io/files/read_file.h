// A whole file in memory.
#pragma once

#include <filesystem>
#include <string>

#include "craze/context.h"

namespace craze {

/// The bytes of a file; pipes and devices are read to their end, a pipe without a writer is waited
/// for. Throws Error(input) "WHAT (PATH): WHY" where the path is missing, a folder or not readable,
/// and Cancelled.
std::string read_file(const std::filesystem::path& path, const char* what = "cannot read mesh",
                      const Context& context = {});

}  // namespace craze
