// Ctrl-C: the first asks the run to stop and write what it has, the second kills the process.
#pragma once

namespace craze::app {

/// Installs the handler; from then on was_interrupted() tells whether Ctrl-C was pressed.
void catch_interrupt();
bool was_interrupted();

}  // namespace craze::app
