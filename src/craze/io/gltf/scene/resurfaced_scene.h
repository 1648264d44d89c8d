// A kept glTF scene as GLB, with another surface in place of its own.
#pragma once

#include <string>

#include "craze/context.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/surface_mesh.h"
#include "craze/write_mesh.h"

namespace craze {

/// The document with its nodes as they were, each showing those faces of `mesh` that lie on the
/// part of the surface that it showed (face_objects, which must be there), in its own axes, with
/// the materials that they had. Of vertices there is what `mesh` has: joints and morph targets are
/// gone, what they did at rest is done. With options.objects fragments are nodes below. Crack lines
/// are one node at the top. options.animation is one more animation, "growth". Throws as
/// format_scene does.
std::string format_resurfaced(const SurfaceMesh& mesh, const GltfDocument& document,
                              const MeshFileOptions& options, const Context& context);

}  // namespace craze
