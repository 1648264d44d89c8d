// Universal Scene Description, as text.
#pragma once

#include "craze/context.h"
#include "craze/io/bytes/byte_sink.h"
#include "craze/surface_mesh.h"
#include "craze/write_mesh.h"

namespace craze {

/// The mesh as USDA: an Xform "craze" with one Mesh, or one per object, each with a place of its
/// own; UVs as primvars:st, normals, colours as displayColor, vertex and face attributes as
/// primvars of their names; a material per name (UsdPreviewSurface) with the looks of the options,
/// bound to GeomSubsets. Numbers are in single precision, places of meshes in double, so that a
/// mesh far from the origin keeps its digits. Names become identifiers, each once; the original
/// stays as displayName. An animation becomes time samples of the points. The unit is the
/// mesh's, else that of the options, else a metre; y is up unless they say z. Warns of textures
/// that it cannot name. Throws Error(request) for a mesh that single precision cannot hold, and
/// Cancelled.
void write_usda(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
                const Context& context);

}  // namespace craze
