#include "craze/mesh/remesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "craze/error.h"
#include "craze/mesh/remesh/remesh_approach.h"
#include "craze/mesh/remesh/remesh_edges.h"
#include "craze/mesh/remesh/remesh_progress.h"
#include "craze/mesh/remesh/remesh_surface.h"
#include "craze/mesh/remesh/remesh_transfer.h"
#include "craze/mesh/remesh/remesh_vertices.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze {

namespace {

constexpr double first_shake = 0.3;  // of the length wanted: against the grain of the input

/// Where edges are a few steps of the coordinates' numbers long, their ends round onto each other
/// and rounds of splits and collapses do not settle: from 8 steps down, measured.
void refuse_too_far(const SurfaceMesh& input, double edge) {
  constexpr double fewest_steps = 12;
  double farthest = 0;
  for (const Vec3& p : input.positions) farthest = std::max(farthest, p.lpNorm<Eigen::Infinity>());
  const double step = std::nextafter(farthest, std::numeric_limits<double>::infinity()) - farthest;
  if (edge >= fewest_steps * step) return;
  std::ostringstream where, why;
  where << "mesh.edge " << edge;
  why << "numbers of " << farthest << " have steps of " << step << ", and an edge needs "
      << fewest_steps << "; move the mesh nearer to the origin, or ask for longer edges";
  throw Error(ErrorKind::request, "too far from the origin to be remeshed", where.str(), why.str());
}

/// The remeshed plane, which has nothing to approach and no attributes.
SurfaceMesh flat_torus(const RemeshSurface& s) {
  SurfaceMesh made;
  std::vector<std::int32_t> kept;
  made.triangles = s.mesh.compact(kept);
  for (const std::int32_t v : kept) {
    made.positions.push_back(s.mesh.period().wrapped(s.mesh.position(v)));
  }
  return made;
}

}  // namespace

SurfaceMesh remesh(const SurfaceMesh& input, const RemeshOptions& options, const Context& context) {
  if (!(options.target_edge > 0) || !std::isfinite(options.target_edge)) {
    throw Error(ErrorKind::request, "bad edge length", std::to_string(options.target_edge),
                "a positive number is needed");
  }
  const TriangleMesh topology(input.positions, input.triangles, options.period);
  if (topology.face_count() == 0) return input;
  refuse_too_far(input, options.target_edge);
  // Of a round five, then approach and transfer; the first is setting up.
  RemeshProgress progress(context, 5 * options.iterations + 3);
  progress.next_stage(topology.face_count());
  RemeshSurface s(input, topology, options, progress);
  const auto stage = [&](auto&& work) {
    progress.next_stage(s.mesh.face_slots());
    work();
  };
  for (int round = 0; round < options.iterations; ++round) {
    stage([&] { split_long_edges(s); });
    stage([&] { collapse_short_edges(s); });
    stage([&] { flip_edges(s); });
    stage([&] { smooth(s, round == 0 ? first_shake : 0); });
    stage([&] { flip_edges(s); });
  }
  if (options.period.is_given()) {
    progress.finish(s.mesh.face_slots());
    return flat_torus(s);
  }
  stage([&] {
    pull_vertices(s);
    approach_input(s);
  });
  progress.next_stage(s.mesh.face_slots());
  SurfaceMesh made = transfer_attributes(s, progress.stage());
  progress.finish(std::ssize(made.triangles));
  return made;
}

}  // namespace craze
