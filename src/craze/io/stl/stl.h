// Stereolithography files.
#pragma once

#include <string>
#include <string_view>

#include "craze/io/bytes/byte_sink.h"
#include "craze/io/mesh_source.h"
#include "craze/surface_mesh.h"
#include "craze/write_mesh.h"

namespace craze {

/// Reads ascii and binary STL, told apart by content: a binary file may well begin with "solid",
/// and bytes may follow its last triangle. Records longer than 50 bytes are read where their
/// attribute byte counts account for the whole file. Corners at equal positions become one vertex,
/// numbered by first appearance; normals are ignored. Colours of faces (VisCAM's and SolidView's,
/// or Magics' where the header has "COLOR=") become the face attributes red, green and blue, 0 …
/// 255; a face without one is white. Throws Error(input).
SurfaceMesh read_stl(const MeshSource& source);

/// Whether the size is that of a binary file, or the text begins with "solid".
bool is_stl(std::string_view bytes);

/// The triangles as binary STL, in single precision; a triangle without area has normal zero. The
/// face attributes red, green and blue, 0 … 255, become VisCAM's colours, of five bits each.
/// Warns, with the loss measured, where that moves vertices by more than 10⁻⁶ of the mesh's size.
/// Throws Error(request) where a coordinate is too large for that.
void write_stl(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
               const Context& context);

}  // namespace craze
