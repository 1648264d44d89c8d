// What of a surface's data a file format has no place for.
#pragma once

#include <string>
#include <string_view>

#include "craze/surface_mesh.h"

namespace craze {

class SourceScene;  // read_mesh.h

/// One sentence that names what the surface has and a file of that format ("obj") has not; empty
/// where all is kept. Left out of it: what every run adds to a surface (docs/outputs.md), and what
/// `scene`, which may be null, counts among its own contents and is told of by the writer.
std::string describe_lost_data(const SurfaceMesh& surface, std::string_view format,
                               const SourceScene* scene);

/// One sentence that names the surface's own attributes whose names a run's take (those of a
/// cracked file that is cracked again, say); empty where there are none.
std::string describe_replaced_data(const SurfaceMesh& surface);

}  // namespace craze
