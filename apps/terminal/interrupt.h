// Ctrl-C, or SIGTERM: the first asks the run to stop and write what it has, the second kills.
#pragma once

namespace craze::app {

/// Installs the handlers; from then on was_interrupted() tells whether a signal came.
void catch_interrupt();
bool was_interrupted();

/// What a process that a signal ended is said to exit with: 130 after Ctrl-C, 143 after SIGTERM.
int interrupt_code();

}  // namespace craze::app
