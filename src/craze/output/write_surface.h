// A surface as a file, with all that its own file held: what every front end writes alike.
#pragma once

#include <functional>
#include <string>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/mesh/morph_animation.h"
#include "craze/output/source_file.h"
#include "craze/products/opening/opened_surface.h"

namespace craze {

struct SurfaceFileOptions {
  std::string objects = {};                   ///< as in MeshFileOptions
  const MorphAnimation* animation = nullptr;  ///< likewise
  double crease = 75;  ///< degrees; GLB: sharper edges of a surface without normals are hard
  /// Told, in one sentence each, what the format cannot hold; may be empty.
  std::function<void(const std::string&)> warn = {};
};

/// Writes a surface of a run: `mesh` is that of `shown`, or has its faces and vertices and more
/// attributes. In GLB shut cracks are lines unless post.lines says no or there are objects, and
/// there are normals. Pieces that are solids are objects of their own in every format that knows
/// objects. Throws as write_mesh does.
void write_surface(const std::string& path, const SurfaceMesh& mesh, const OpenedSurface& shown,
                   const Result& result, const SourceFile& source,
                   const SurfaceFileOptions& options, const Context& context);

/// Writes a surface as it was read, or with more attributes.
void write_surface(const std::string& path, const SurfaceMesh& mesh, const SourceFile& source,
                   const SurfaceFileOptions& options, const Context& context);

}  // namespace craze
