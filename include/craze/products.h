// What can be made of a finished run: meshes, lines, growth, numbers. Each is computed when asked
// for, from the result alone; nothing is cracked again.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/line_set.h"
#include "craze/recipe.h"
#include "craze/surface_mesh.h"

namespace craze {

struct SurfaceOrigin;
struct OpenedSurface;

/// The cut mesh, shut, with everything known of it. Attributes of these names that the surface
/// already has are replaced.
/// Per vertex: crack_distance, length along the surface to the nearest crack, the diagonal of the
/// box where there is none; crack_time, the load when that crack opened, and crack_growth, 0 … 1,
/// when it came by in a clip of the growth, both −1 where there is none; displacement, [IO06 Eq. 9]
/// with γ = 1, length. Per face: fragment, the part of the cut mesh; source_face, the input's face.
/// Throws Cancelled.
SurfaceMesh cut_mesh(const Result& result, const Context& context);

/// The cut mesh with its cracks open: gaps, side walls, curl (section 5 of the paper). Immutable
/// and cheap to copy.
class Opening {
 public:
  /// Lengths have no units (with_post). Throws Error(request): negative or not finite; Cancelled.
  Opening(const Result& result, const PostParameters& post, const Context& context);

  /// The vertices and faces of cut_mesh() come first, in its order, then those of side walls, whose
  /// material is "crack_wall".
  const SurfaceMesh& mesh() const;
  /// Where in the input each face of mesh() lies (surface_origin.h), as mesh.output = "asset"
  /// keeps it; else empty.
  SurfaceOrigin origin() const;
  /// What could not be done as asked, a sentence each.
  const std::vector<std::string>& warnings() const;

  /// What it was made of, and what mesh() is part of (products/opening/opened_surface.h).
  const Result& result() const;
  const OpenedSurface& surface() const;

 private:
  friend class GrowthClip;
  struct State;
  std::shared_ptr<const State> state_;
};

/// An opening as it comes to be, crack by crack, from 0 (no crack) to 1 (all of them).
class GrowthClip {
 public:
  explicit GrowthClip(const Opening& opening);

  /// #V of the opening's mesh, model units: its vertices at a time of the clip.
  std::vector<Vec3> positions_at(double time) const;
  /// #V, 0 … 1: how far the crack at each vertex is open by then; 0 away from cracks.
  std::vector<double> openness_at(double time) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// The cracks as a graph on the surface; edges meet only at points. Point attributes: junction (0
/// end, 1 bend, 2 junction, 3 on the border), normal. Edge attributes: time, the load when it
/// opened; width, length, [IO06 Eq. 9] with γ = 1; event, the number of the crack. UVs, two per
/// edge, where the surface has some. Throws Cancelled.
LineSet crack_lines(const Result& result, const Context& context = {});

/// The parts of a mesh by its face attribute `fragment`, in order; each has what the whole has.
/// Throws Error(request) where there is no such attribute, and Cancelled.
std::vector<SurfaceMesh> fragments(const SurfaceMesh& mesh, const Context& context = {});

/// The report of a run as JSON (docs/outputs.md), its pattern's statistics included. Throws
/// Cancelled.
std::string report_json(const Result& result, const Context& context = {});

/// The statistics of a run's pattern as JSON (docs/statistics.md); "{}" where nothing cracked.
/// Throws Cancelled.
std::string statistics_json(const Result& result, const Context& context = {});

/// The same of lines: drawn by as few of their points as stay within `simplify` of them, a length;
/// 0: as they are. Throws Error(request) for lines that are not in a plane and have no
/// normals, and Cancelled.
std::string statistics_json(const LineSet& lines, double simplify, const Context& context = {});

}  // namespace craze
