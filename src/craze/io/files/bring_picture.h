// Pictures that a mesh's file names.
#pragma once

#include <string>

#include "craze/io/mesh_source.h"

namespace craze {

struct BroughtPicture {
  std::string bytes;
  std::string why;  ///< there are none, in a few words; "": there are
};

/// The bytes of a PNG or JPEG by a name as of plain_file_name(). Throws Cancelled.
BroughtPicture bring_picture(const std::string& name, const MeshSource& source);

}  // namespace craze
