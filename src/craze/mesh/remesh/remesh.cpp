#include "craze/mesh/remesh/remesh.h"

#include <cmath>
#include <string>

#include "craze/error.h"
#include "craze/mesh/remesh/remesh_approach.h"
#include "craze/mesh/remesh/remesh_edges.h"
#include "craze/mesh/remesh/remesh_surface.h"
#include "craze/mesh/remesh/remesh_transfer.h"
#include "craze/mesh/remesh/remesh_vertices.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze {

namespace {

constexpr double first_shake = 0.3;  // of the length wanted: against the grain of the input

}  // namespace

SurfaceMesh remesh(const SurfaceMesh& input, const RemeshOptions& options, const Context& context) {
  if (!(options.target_edge > 0) || !std::isfinite(options.target_edge)) {
    throw Error(ErrorKind::request, "bad edge length", std::to_string(options.target_edge),
                "a positive number is needed");
  }
  const TriangleMesh topology(input.positions, input.triangles);
  if (topology.face_count() == 0) return input;
  RemeshSurface s(input, topology, options, context);
  for (int round = 0; round < options.iterations && !context.is_cancelled(); ++round) {
    context.report({"prepare", static_cast<double>(round) / (options.iterations + 1)});
    split_long_edges(s);
    collapse_short_edges(s);
    flip_edges(s);
    smooth(s, round == 0 ? first_shake : 0);
    flip_edges(s);
  }
  if (!context.is_cancelled()) {
    pull_vertices(s);
    approach_input(s);
  }
  return transfer_attributes({input, s.patch, s.tree}, s.mesh, context.threads);
}

}  // namespace craze
