// Numbers in files of either byte order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

namespace craze {

/// The number of type T whose bytes start at `bytes`, of any alignment.
template <class T>
T load(const char* bytes, std::endian order = std::endian::little) {
  T value;
  if (order == std::endian::native) {
    std::memcpy(&value, bytes, sizeof(T));
  } else {
    char reversed[sizeof(T)];
    std::reverse_copy(bytes, bytes + sizeof(T), reversed);
    std::memcpy(&value, reversed, sizeof(T));
  }
  return value;
}

/// Writes the number at `bytes` in little-endian order.
template <class T>
void store(char* bytes, T value) {
  std::memcpy(bytes, &value, sizeof(T));
  if (std::endian::native != std::endian::little) std::reverse(bytes, bytes + sizeof(T));
}

/// Appends the number to `bytes` in little-endian order.
template <class T>
void append(std::string& bytes, T value) {
  char buffer[sizeof(T)];
  store(buffer, value);
  bytes.append(buffer, sizeof(T));
}

}  // namespace craze
