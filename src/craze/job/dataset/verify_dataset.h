// Whether a set is whole.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "craze/context.h"

namespace craze {

/// What is wrong with a set, a sentence each; none: it is whole, every byte is what it was, and
/// nothing lies there that is not the plan's. Reads all of it, a file at a time. Throws
/// Error(input) where it is no set, and Cancelled.
std::vector<std::string> verify_dataset(const std::filesystem::path& folder,
                                        const Context& context);

}  // namespace craze
