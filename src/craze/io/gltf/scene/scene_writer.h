// A kept glTF scene as GLB, its surface cracked.
#pragma once

#include <string>

#include "craze/context.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/surface_mesh.h"
#include "craze/write_mesh.h"

namespace craze {

/// The document with the primitives that cracks touch replaced, and all else as it was. `mesh` was
/// made of the document's surface as options.origin says. A primitive that nothing touched keeps
/// its accessors byte for byte; in a touched one the old vertices come first, with their bytes
/// unless they moved, and then those that the cracks made. Nodes that show one mesh get one of
/// their own where they crack. Side walls are further primitives of the mesh, crack lines nodes
/// below the part's. Throws Error(request) for coordinates beyond single precision and for more
/// than 4 GB, and Cancelled.
std::string format_scene(const SurfaceMesh& mesh, const GltfDocument& document,
                         const MeshFileOptions& options, const Context& context);

}  // namespace craze
