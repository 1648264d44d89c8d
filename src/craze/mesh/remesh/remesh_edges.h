// The steps of remeshing that change how vertices are joined.
#pragma once

#include "craze/mesh/remesh/remesh_surface.h"

namespace craze {

/// Splits the longest edges first and flips whenever the longest have come down by a third: coarse
/// faces then fall into well-shaped ones.
void split_long_edges(RemeshSurface& s);

/// Collapses edges that are too short, where no face folds or stretches and the surface stays near.
void collapse_short_edges(RemeshSurface& s);

/// A few sweeps of Lawson flips: in the plane they end in the Delaunay triangulation.
void flip_edges(RemeshSurface& s);

}  // namespace craze
