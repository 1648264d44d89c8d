#include "app.h"

namespace craze::app {

CLI::Validator not_negative() {
  return CLI::Validator(
      [](std::string& text) {
        double value = 0;
        // NaN compares with nothing.
        return CLI::detail::lexical_cast(text, value) && value >= 0
                   ? std::string()
                   : text + " is out of range: must be at least 0";
      },
      "");
}

}  // namespace craze::app
