// Writing a file whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

#include "craze/context.h"

namespace craze {

/// Puts `bytes` at `path`. A regular or new file is written beside its place and renamed, so that a
/// reader never sees a part of it and a failure leaves what was there; a symbolic link keeps
/// pointing where it does. Pipes and devices (/dev/stdout) are written directly; a pipe is waited
/// for. Throws Error(output) "WHAT (PATH): WHY" with the system's reason, and Cancelled.
void write_file(const std::filesystem::path& path, std::string_view bytes,
                const char* what = "cannot write file", const Context& context = {});

}  // namespace craze
