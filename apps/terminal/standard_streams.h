// The three streams that every program expects to find open.
#pragma once

namespace craze::app {

/// Puts something in the place of those that are closed: else the first files that are opened
/// would take their numbers, and messages would be written into them. Reading finds nothing there,
/// writing fails.
void fill_standard_streams();

}  // namespace craze::app
