// The growth of the cracks: frames, a video, one mesh that moves.
#pragma once

#include "craze/base/context.h"
#include "craze/io/gltf/morph_animation.h"
#include "craze/model/simulation.h"
#include "craze/post/growth_motion.h"
#include "craze/render/picture.h"
#include "craze/scenario/run.h"
#include "craze/scenario/shown_surface.h"

namespace craze {

/// What is seen of a run at any time of its clip. Keeps references to all it is given.
class GrowthScene {
 public:
  /// `surface` is what the simulation started with.
  GrowthScene(const RunRequest& request, const Simulation& simulation, const SurfaceMesh& surface,
              const ShownSurface& shown, const CrackSites& sites, const CrackSchedule& schedule);

  /// The shown mesh as it opens, in the stages that the request asks for.
  MorphAnimation animation() const;

  /// The frames and the video that the request asks for, at equal steps of the clip from no crack
  /// to all: pictures, or meshes that all have the triangles of the last one and the vertex
  /// attribute `openness`, 0 … 1.
  void write_frames(const render::PictureOptions& options, const Context& context) const;

 private:
  class Photographer;

  SurfaceMesh mesh_at(double time) const;
  /// Per side of a crack, how far its two ends are open.
  std::vector<std::array<float, 2>> side_openness(double time) const;

  const RunRequest& request_;
  const Simulation& simulation_;
  const SurfaceMesh& surface_;
  const ShownSurface& shown_;
  const CrackSites& sites_;
  const CrackSchedule& schedule_;
  GrowthMotion motion_;
};

}  // namespace craze
