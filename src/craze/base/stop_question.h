// How a long computation that leaves a consistent state asks whether to go on.
#pragma once

#include <functional>

namespace craze {

/// Asked now and then, in the caller's thread; returns whether to stop. Empty: never.
using StopQuestion = std::function<bool()>;

}  // namespace craze
