// Steps of pixels taken out of the lines of a skeleton.
#pragma once

#include "craze/products/statistics/graph/graph_input.h"

namespace craze {

/// Leaves out points in the middle of a crack line as long as the line stays within `tolerance`
/// (length) of all of them [Ramer 1972; Douglas & Peucker 1973]. Junctions, ends, borders and
/// points where time, event or pieces change stay. The lines of a skeleton run from pixel to pixel
/// and are up to 8 % too long; within a pixel their steps are gone. O(#E log #E) expected.
void simplify_lines(CrackGraphInput& graph, double tolerance);

}  // namespace craze
