// The elements of a glTF accessor as bytes, each number as the file has it.
#pragma once

#include <cstddef>
#include <string>

namespace craze {

/// The componentType of numbers in single precision.
inline constexpr std::size_t float_type = 5126;

/// Bytes of a number of that componentType; 0 for an unknown one.
std::size_t component_size(std::size_t component_type);

/// Elements one after another without gaps, little-endian, in their own component type.
struct GltfElements {
  std::size_t count = 0, components = 1, component_type = float_type;
  bool normalized = false;  ///< integers stand for 0 … 1 or −1 … 1
  std::string bytes;        ///< count × size()

  /// Bytes of one element.
  std::size_t size() const { return components * component_size(component_type); }
  /// A number as it is meant: normalized integers are scaled.
  double value(std::size_t element, std::size_t component) const;
  /// Appends an element: numbers as they are meant, rounded and clamped to what the type holds.
  void append(const double* values);
  void append_copy(std::size_t element);
  /// Puts numbers in an element's place.
  void set(std::size_t element, const double* values);
  /// Whether two elements have the same bytes.
  bool same(std::size_t a, std::size_t b) const;
};

/// The number at `bytes`, scaled where it is normalized.
double load_component(const char* bytes, std::size_t component_type, bool normalized);

/// The same numbers in single precision.
GltfElements as_floats(const GltfElements& elements);

}  // namespace craze
