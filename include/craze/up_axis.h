// Which way is up on an object.
#pragma once

namespace craze {

enum class UpAxis {
  automatic,  ///< z for a flat plate in the xy plane, else y; upside down where that is its front
  x,
  y,
  z,
};

}  // namespace craze
