#include "craze/engine/check_scale.h"

#include <unistd.h>

#include <cmath>
#include <limits>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/mesh/bounding_diagonal.h"

namespace craze {

namespace {

// Measured at the end of runs with all outputs: 0.75 to 0.95 kB, and half of it again for cracks.
constexpr double bytes_per_triangle = 1400;

double total_area(const SurfaceMesh& surface, const Period& period) {
  double area = 0;
  for (const Triangle& t : surface.triangles) {
    const Vec3& a = surface.positions[t[0]];
    const Vec3 ab = period.shortest(surface.positions[t[1]] - a);
    area += 0.5 * ab.cross(period.shortest(surface.positions[t[2]] - a)).norm();
  }
  return area;
}

}  // namespace

double physical_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return std::numeric_limits<double>::infinity();
  return static_cast<double>(pages) * static_cast<double>(page);
}

void check_scale(const SurfaceMesh& surface, const Recipe& recipe, double target_edge,
                 double memory, const Period& period) {
  const double spacing = recipe.simulation.layer.spacing;
  const double diagonal = bounding_diagonal(surface.positions, period);
  if (spacing > diagonal) {
    throw Error(ErrorKind::request, "spacing larger than the object", "layer.spacing",
                fmt::format("{:.4g} between cracks, but the object is {:.4g} from end to end; give "
                            "a part of that",
                            spacing, diagonal));
  }
  if (target_edge <= 0) return;
  if (target_edge > diagonal) {
    throw Error(ErrorKind::request, "edge longer than the object", "mesh.edge",
                fmt::format("{:.4g} long, but the object is {:.4g} from end to end; give a part of "
                            "that",
                            target_edge, diagonal));
  }
  // Equilateral triangles of that edge.
  const double triangles =
      total_area(surface, period) / (std::sqrt(3.0) / 4 * target_edge * target_edge);
  const double needed = triangles * bytes_per_triangle;
  if (needed <= memory) return;
  const bool given = recipe.mesh.edge.kind == EdgeLength::Kind::given;
  const double most = std::sqrt(needed / memory);  // of lengths, whatever they are
  const double length = recipe.simulation.layer.screening_length;
  const double asked = given ? target_edge : spacing > 0 ? spacing : length;
  throw Error(
      ErrorKind::request,
      given ? "edge too short for this machine" : "spacing too small for this machine",
      given         ? "mesh.edge"
      : spacing > 0 ? "layer.spacing"
                    : "layer.screening_length",
      fmt::format(
          "edges of {:.3g} make about {:.3g} triangles, which need {:.3g} GB of memory where "
          "there are {:.3g}; {:.2g} or more would do",
          target_edge, triangles, needed / 1e9, memory / 1e9, asked * most));
}

}  // namespace craze
