// Pipes whose other end is not there yet, or is slow: waited for without being deaf to a cancel.
#pragma once

#include "craze/context.h"

namespace craze {

enum class PipeEnd { read, write };

/// Returns when the descriptor can be read or written, or its other end has gone. Throws Cancelled.
void wait_for_pipe(int descriptor, PipeEnd end, const Context& context);

/// Opens what is not a regular file, without blocking; a named pipe is waited for until it has a
/// reader. Negative where it cannot be opened; errno says why. Throws Cancelled.
int open_for_writing(const char* path, const Context& context);

}  // namespace craze
