// Samples side by side, with their labels over them.
#pragma once

#include <filesystem>

#include "craze/context.h"
#include "craze/render/image.h"

namespace craze {

struct SheetOptions {
  int samples = 16;  ///< at most; evenly taken from the shards that are there
  int columns = 4;   ///< samples in a row, each a picture and the same with its labels
  int size = 256;    ///< width of a picture on the sheet, pixels
};

/// Each sample twice: as it is, and with its mask in red and its junctions as dots: ends blue, T
/// green, Y yellow, X and others white. Throws Error(input) where there is nothing to show, and
/// Cancelled.
render::Image contact_sheet(const std::filesystem::path& folder, const SheetOptions& options,
                            const Context& context);

}  // namespace craze
