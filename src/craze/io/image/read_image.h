// Pictures from bytes, or from files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "craze/base/image.h"
#include "craze/context.h"

namespace craze {

/// A PNG of any kind (8 or 16 bits, palette and fewer bits expanded) or a JPEG (grey or colours),
/// told apart by its first bytes, values as stored: no gamma. `name` stands for the file in
/// messages. Throws Error(input) "cannot read picture (NAME): WHY" for what is damaged, of another
/// format or one that this build leaves out, or over 16,384 pixels wide or high or 67 million in
/// all.
Image read_image(std::string_view bytes, const std::string& name);

/// The same from a file. Throws Cancelled too.
Image read_image_file(const std::filesystem::path& path, const Context& context = {});

}  // namespace craze
