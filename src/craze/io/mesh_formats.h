// The one table of mesh formats: a new one is a file of its own and a row here.
#pragma once

#include <span>
#include <string_view>

#include "craze/io/bytes/byte_sink.h"
#include "craze/io/mesh_source.h"
#include "craze/surface_mesh.h"
#include "craze/write_mesh.h"

namespace craze {

struct MeshFormat {
  std::string_view name;  ///< in lower case; files end with "." and this
  /// Whether bytes can only be of this format; null where nothing tells.
  bool (*recognises)(std::string_view bytes);
  /// Null: not read.
  SurfaceMesh (*read)(const MeshSource& source);
  /// Null: not written. Reports "write" and throws Cancelled.
  void (*write)(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
                const Context& context);
  bool holds_objects;    ///< MeshFileOptions::objects
  bool holds_animation;  ///< MeshFileOptions::animation
};

/// All formats, in the order in which they are listed and asked whether they know some bytes.
std::span<const MeshFormat> mesh_formats();

/// The format of that name or extension (".PLY"), or nullptr.
const MeshFormat* find_mesh_format(std::string_view name_or_extension);

}  // namespace craze
