// The growth of the cracks as frames and a video.
#pragma once

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/job/run.h"
#include "craze/products/growth/growth.h"
#include "craze/render/picture.h"

namespace craze {

/// What the frames show.
struct GrowthScene {
  const Result& result;
  const OpenedSurface& shown;
  const Growth& growth;
};

/// The frames and the video that the request asks for, at equal steps of the clip from no crack to
/// all: pictures, or meshes that all have the triangles of the last one and the vertex attribute
/// `openness`, 0 … 1. Throws Error(output) and Cancelled; each file is whole or not there.
void write_frames(const RunRequest& request, const GrowthScene& scene,
                  const render::PictureOptions& options, const Context& context);

}  // namespace craze
