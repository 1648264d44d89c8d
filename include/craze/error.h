// The exceptions that leave the library.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>

namespace craze {

/// What went wrong decides the exit code: a wrong call is 2, everything else 1.
enum class ErrorKind {
  usage,    ///< a wrong option, key or value
  input,    ///< a file that cannot be read or is not what it says
  request,  ///< something impossible was asked of a good input
  output,   ///< a file that cannot be written
};

/// what() is "WHAT (WHERE): WHY": the thing that failed, the file, key or line, and what to do.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& what, const std::string& where, const std::string& why)
      : std::runtime_error(what + (where.empty() ? "" : " (" + where + ")") + ": " + why),
        kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

/// Not an error: the context cancelled before there was anything to keep.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace craze
