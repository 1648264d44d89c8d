// The constructions behind null_models.h. Windows are [0, side]².
#pragma once

#include <cstdint>

#include "craze/model/crack_network.h"

namespace craze {

/// Of a Poisson process of intensity 1, stationary up to the window's border.
CrackNetwork voronoi_network(double side, std::uint64_t seed);

/// Largest cell first, cut square to its longer side at a uniform fraction in [low, high].
CrackNetwork orthogonal_network(double side, std::int32_t cells, double low, double high,
                                std::uint64_t seed);

/// Isotropic STIT tessellation (Nagel & Weiss 2005), stopped at the given number of cells.
CrackNetwork stit_network(double side, std::int32_t cells, std::uint64_t seed);

enum class Lattice { square, hexagonal, brick };

/// Cells of area 1.
CrackNetwork lattice_network(Lattice lattice, double side);

}  // namespace craze
