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

/// One sentence that names the vertex attributes of which a file of that format holds other whole
/// numbers than the surface, such as ids beyond 2^24 in single precision; empty where there are
/// none.
std::string describe_rounded_data(const SurfaceMesh& surface, std::string_view format);

/// One sentence where a file of that format has lengths of another size than the surface, one unit
/// of which is so many metres (0: not known); else empty.
std::string describe_unit(double metres_per_unit, std::string_view format);

/// One sentence that names the surface's own attributes whose names a run's take (those of a
/// cracked file that is cracked again, say); empty where there are none.
std::string describe_replaced_data(const SurfaceMesh& surface);

}  // namespace craze
