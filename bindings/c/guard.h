// Keeps exceptions on this side of the interface.
#pragma once

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "craze/craze.h"
#include "craze/error.h"

namespace craze::c {

inline craze_status report(craze_error* error, craze_status status, std::string_view message) {
  if (!error) return status;
  error->status = status;
  std::size_t length = std::min(message.size(), sizeof error->message - 1);
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  if (length < message.size()) {
    while (length > 0 && continues(message[length])) --length;  // no half character of UTF-8
  }
  std::memcpy(error->message, message.data(), length);
  error->message[length] = '\0';
  return status;
}

inline craze_status status_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return CRAZE_USAGE;
    case ErrorKind::input:
      return CRAZE_INPUT;
    case ErrorKind::request:
      return CRAZE_REQUEST;
    case ErrorKind::output:
      return CRAZE_OUTPUT;
  }
  return CRAZE_INTERNAL;
}

/// Runs body(); what it throws becomes a status and a message.
template <class Body>
craze_status guard(craze_error* error, Body&& body) noexcept {
  try {
    body();
    return report(error, CRAZE_OK, "");
  } catch (const Error& e) {
    return report(error, status_of(e.kind()), e.what());
  } catch (const Cancelled& e) {
    return report(error, CRAZE_CANCELLED, e.what());
  } catch (const std::bad_alloc&) {
    return report(error, CRAZE_MEMORY, "not enough memory");
  } catch (const std::length_error&) {
    return report(error, CRAZE_MEMORY, "not enough memory");
  } catch (const std::exception& e) {
    return report(error, CRAZE_INTERNAL, e.what());
  } catch (...) {
    return report(error, CRAZE_INTERNAL, "unknown failure");
  }
}

/// The same for functions that return a pointer: what body() returns, or null.
template <class Body>
auto guarded(craze_error* error, Body&& body) noexcept -> decltype(body()) {
  decltype(body()) result = nullptr;
  guard(error, [&] { result = body(); });
  return result;
}

[[noreturn]] inline void wrong_argument(const char* what, const char* where, const char* why) {
  throw Error(ErrorKind::usage, what, where, why);
}

/// Refuses a null handle or pointer.
inline void require(const void* pointer, const char* name) {
  if (!pointer) wrong_argument("wrong argument", name, "it is NULL");
}

/// The i-th of them, null beyond the last.
inline const char* text_at(const std::vector<std::string>& texts, int64_t i) {
  if (i < 0 || i >= static_cast<int64_t>(texts.size())) return nullptr;
  return texts[static_cast<std::size_t>(i)].c_str();
}

/// A copy that craze_text_free() takes back.
char* copy_text(std::string_view text);

}  // namespace craze::c
