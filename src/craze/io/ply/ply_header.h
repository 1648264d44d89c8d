// The header of a PLY file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace craze {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Bytes of one value in a binary file.
std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  ///< of the value, or of the list's items
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> materials;  ///< of "comment material NAME" lines
  std::vector<std::string> textures;   ///< of "comment TextureFile NAME" lines
  std::vector<std::string> comments;   ///< those lines and others, but for materials and our own
  std::vector<std::string> infos;      ///< of "obj_info" lines
  std::size_t size = 0;                ///< bytes up to and with the end_header line
  std::size_t lines = 0;
};

/// Throws Error(input) at the header's line. Counts are as the file says, not checked yet.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

}  // namespace craze
