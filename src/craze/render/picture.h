// A mesh and its cracks, photographed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "craze/context.h"
#include "craze/material/material.h"
#include "craze/render/camera.h"
#include "craze/render/image.h"
#include "craze/render/light/studio.h"
#include "craze/render/material/crack_lines.h"
#include "craze/render/material/look.h"
#include "craze/render/material/marks.h"
#include "craze/render/subject.h"
#include "craze/surface_mesh.h"

namespace craze::render {

struct PictureOptions {
  static constexpr int largest_size = 16384;

  int width = 1280, height = 960;  ///< pixels, 1 to largest_size
  int samples = 16;                ///< per pixel, rounded up to a multiple of 16
  View view;
  /// What the camera frames, what stands on the floor and what sizes are measured by, for pictures
  /// that belong together; without points: the mesh's (subject_of).
  Subject subject;
  LampPlace light;
  EnvironmentPlace environment;
  Material material = find_material("clay");
  /// The mesh's own colours, one per material of it, or one for all; empty: the material's. Walls
  /// and cracks keep the material's, and clear glass has none of its own.
  std::vector<Look> looks;
  /// UVs of further sets, 1, 2 …, 3 #F of the mesh each, or none of a set. Textures of sets that
  /// there are not do not count.
  std::vector<std::vector<Vec2>> further_uvs;
  std::vector<Mark> marks;      ///< on the mesh, model units; clear glass has none
  std::optional<Rgb> backdrop;  ///< by default the material's
  bool ground = true;           ///< a floor that catches the shadow
  double line_width = 0;  ///< of a crack line, model units; 0: a fixed part of the mesh's diagonal
  double crease = 75;     ///< degrees: sharper edges are shaded as edges, if normals are not given
  float exposure = 1;
  std::uint64_t seed = 1;
};

/// The width of crack lines that a picture of this mesh will use, model units.
double line_width(const SurfaceMesh& mesh, const PictureOptions& options);

/// How far from a crack its line reaches: the distance to bake crack_lines() with.
double line_reach(const SurfaceMesh& mesh, const PictureOptions& options);

/// Where a picture is taken from. Points of the model are there scale (p − centre): render units,
/// near the origin and of unit size.
struct PictureCamera {
  Camera camera;
  Vec3 centre;
  double scale;
};

/// The camera of a picture of this mesh, which must have triangles.
PictureCamera picture_camera(const SurfaceMesh& mesh, const PictureOptions& options);

/// The normals that a picture is shaded with: 3 #F, unit.
std::vector<Vec3f> shading_normals(const SurfaceMesh& mesh, double crease);

/// Shaded with the mesh's corner normals if it has them. Faces in the material slot "crack_wall"
/// take the material's wall colour. `lines` may be null; they belong to the first faces of `mesh`,
/// and faces beyond them, such as walls, have none. The picture does not depend on the number of
/// threads. Throws Error(request) for an empty mesh, a mesh that is not finite, or a size out of 1
/// … 16384, and Cancelled.
Image render_picture(const SurfaceMesh& mesh, const CrackLines* lines,
                     const PictureOptions& options, const Context& context);

}  // namespace craze::render
