// Moving a vertex onto a crack that passes close by, instead of bending the crack to the vertex.
#pragma once

#include <cstdint>

#include "craze/model/cracked_sheet.h"

namespace craze {

/// Slides the origin v of halfedge h by t (0 < t < 1) of the way to its end. Does nothing and
/// returns false where v is open or pinned; where the surface would move by more than a twentieth
/// of the edge, since it is bent there; or where a face around v would become too thin. In the
/// plane the surface stays as it is.
bool slide_vertex(CrackedSheet& sheet, std::int32_t h, double t);

}  // namespace craze
