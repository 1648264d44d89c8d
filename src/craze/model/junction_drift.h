// From one cycle to the next, junctions of cracks move toward where their three cracks pull alike.
//
// References
// Goehring, Conroy, Akhter, Clegg, Routh: Evolution of mud-crack patterns during repeated drying
// cycles. Soft Matter 6, 2010.
#pragma once

#include "craze/model/crack_network.h"

namespace craze {

/// The cracks of `network` where the next cycle finds them. In each cycle the cracks at a junction
/// open in another order, and the one that comes late ends beside the old junction, on the side of
/// the others. Averaged over orders the junction moves along the sum of the unit vectors of its
/// cracks, which is zero at three angles of 120°. This is that average, with the cracks following
/// their junctions: curve-shortening flow, ∂p/∂t = Σ t̂ / (½ Σ |e|), in the tangent plane, over the
/// time distance²/2, by explicit steps on pieces a quarter of `distance` long. Ends of cracks, on
/// borders too, stay where they are. Lengths never grow.
///
/// distance > 0, length: how far diffusion reaches, hence about how far a junction can move; more
/// than all cracks are long counts as that, and less than 4·10⁻⁷ of it moves nothing.
/// Nodes of the result have positions, normals and kinds, edges have ends.
CrackNetwork drifted(const CrackNetwork& network, double distance);

}  // namespace craze
