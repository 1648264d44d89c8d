// The binary part of a GLB file and the accessors into it.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "craze/io/bytes/byte_sink.h"
#include "craze/tensor.h"

namespace craze {

class GlbBuffer {
 public:
  enum class Target { none, vertices, triangles };  ///< what a view is used for

  /// Each appends one accessor and returns its index. Numbers beyond single precision are clamped.
  std::size_t add_floats(std::span<const float> numbers, int components, Target target);
  std::size_t add_indices(std::span<const std::uint32_t> indices);
  /// With the bounds that POSITION must have.
  std::size_t add_positions(std::span<const std::array<float, 3>> positions);
  /// `count` vectors, zero but for those at `indices` (ascending). With bounds.
  std::size_t add_sparse_vectors(std::size_t count, std::span<const std::uint32_t> indices,
                                 std::span<const std::array<float, 3>> vectors);
  /// Scalars with bounds, as the keys of an animation must have.
  std::size_t add_keys(std::span<const float> keys);

  /// A view of any bytes, such as a picture's.
  std::size_t add_bytes(const std::string& bytes);

  /// Passes the file on: `root` with accessors, views and buffer added, and the bytes. Throws
  /// Error(request) for more than 4 GB.
  void write(nlohmann::ordered_json root, ByteSink& sink) const;

 private:
  template <class T>
  std::size_t add_view(std::span<const T> numbers, Target target);
  std::size_t add_accessor(std::size_t view, int component, std::size_t count, const char* type);

  std::vector<std::string> bytes_;  // of each view
  std::size_t size_ = 0;            // of all
  nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
};

}  // namespace craze
