// Errors that a test expects.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "craze/error.h"

namespace craze {

/// The message of the Error, of that kind where one is given, that `run` throws; fails the test
/// where it throws none.
template <class Run>
std::string error_of(Run run, std::optional<ErrorKind> kind = {}) {
  try {
    run();
  } catch (const Error& e) {
    if (kind) {
      EXPECT_EQ(e.kind(), *kind) << e.what();
    }
    return e.what();
  } catch (const std::exception& e) {
    ADD_FAILURE() << "not an Error: " << e.what();
    return "";
  }
  ADD_FAILURE() << "no error was thrown";
  return "";
}

}  // namespace craze
