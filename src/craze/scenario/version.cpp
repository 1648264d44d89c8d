#include "craze/scenario/version.h"

namespace craze {

std::string version() {
  return CRAZE_VERSION;
}

}  // namespace craze
