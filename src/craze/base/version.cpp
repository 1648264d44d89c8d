#include "craze/base/version.h"

namespace craze {

std::string version() {
  return CRAZE_VERSION;
}

}  // namespace craze
