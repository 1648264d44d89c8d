// What an STL file holds: triangles of their own, and perhaps a colour for each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "craze/io/mesh_source.h"
#include "craze/surface_mesh.h"
#include "craze/tensor.h"

namespace craze {

struct StlFacets {
  std::vector<Vec3> corners;      ///< three each
  std::vector<Attribute> colors;  ///< red, green, blue, 0 … 255; empty where there are none
  std::vector<std::string> solids = {};  ///< names that an ascii file gives them
  std::string title = {};                ///< what a binary file's header says, but for colours
};

/// The header of our own files; must not start with "solid".
inline constexpr std::string_view own_title = "binary STL by craze";

/// Ascii or binary, by content: a binary file may well begin with "solid". Throws Error(input).
StlFacets read_stl_facets(const MeshSource& source);

/// Bytes of a binary file's start, its count of triangles included, and of a triangle's record.
inline constexpr std::size_t stl_header_size = 84, stl_record_size = 50;

/// Where the records of a binary file lie, and what their last two bytes mean.
struct StlRecords {
  std::size_t count = 0;
  /// Each record is as much longer as its attribute byte count says; otherwise that field is free
  /// for other uses, colours among them.
  bool counts_attribute_bytes = false;
  std::size_t unread = 0;  ///< bytes after the last record
};

/// Each reads a file known to be of its kind.
StlFacets read_ascii_stl(const MeshSource& source);
StlFacets read_binary_stl(const MeshSource& source);

/// Throws Error(input) where the file is too short for its records.
StlRecords find_stl_records(const MeshSource& source);

}  // namespace craze
