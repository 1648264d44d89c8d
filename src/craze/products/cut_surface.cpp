#include "craze/products/cut_surface.h"

#include <algorithm>

#include "craze/base/segment_distance.h"
#include "craze/engine/cracked_surface.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/products/distance/nearby_cracks.h"

namespace craze {

namespace {

void set_attribute(std::vector<Attribute>& attributes, Attribute attribute) {
  for (Attribute& old : attributes) {
    if (old.name == attribute.name) {
      old = std::move(attribute);
      return;
    }
  }
  attributes.push_back(std::move(attribute));
}

Attribute make(const char* name, int components, std::int32_t n, double value) {
  return {name, components, std::vector<double>(static_cast<std::size_t>(n) * components, value)};
}

void add_nearest_crack(SurfaceMesh& surface, const CrackedSurface& state,
                       const GrowthTimes& growth_times, const Context& context) {
  const TriangleMesh& mesh = state.mesh();
  const std::vector<double> times = state.crack_times();
  const double far = bounding_diagonal(mesh.positions());
  const std::vector<std::int32_t>& sides = growth_times.sites.sides;
  Attribute distance = make("crack_distance", 1, mesh.vertex_count(), far);
  Attribute time = make("crack_time", 1, mesh.vertex_count(), -1);
  Attribute growth = make("crack_growth", 1, mesh.vertex_count(), -1);
  const auto arrival = [&](const NearbyCrack& seen, const Vec3& p) {
    const auto side = std::lower_bound(sides.begin(), sides.end(), seen.halfedge);
    const auto& [from, to] =
        growth_times.schedule.sides[static_cast<std::size_t>(side - sides.begin())];
    return from + nearest_on_segment(p, seen.a, seen.b) * (to - from);
  };
  // A vertex is of one part of the mesh.
  carry_cracks(mesh, sides, far, context,
               [&](int, std::int32_t f, const NearbyCrack& seen, const CornerDistances& distances) {
                 const double t = times[mesh.crack_of(seen.halfedge)];
                 for (int i = 0; i < 3; ++i) {
                   const std::int32_t v = mesh.triangle(f)[i];
                   const double d = distances[i];
                   if (d > distance.values[v]) continue;
                   // Of cracks that meet at the vertex, the first that opened.
                   const bool tie = d == distance.values[v] && time.values[v] >= 0;
                   if (!tie || t < time.values[v]) time.values[v] = t;
                   const double came = arrival(seen, mesh.position(v));
                   if (!tie || came < growth.values[v]) growth.values[v] = came;
                   distance.values[v] = d;
                 }
               });
  set_attribute(surface.vertex_attributes, std::move(distance));
  set_attribute(surface.vertex_attributes, std::move(time));
  set_attribute(surface.vertex_attributes, std::move(growth));
}

}  // namespace

SurfaceMesh plain_cut_surface(const Result& result, const Threads& threads) {
  return result.state().with_attributes(*result.state().surface, threads);
}

SurfaceMesh cut_surface(const Result& result, const GrowthTimes& times, const Context& context) {
  const CrackedSurface& state = result.state();
  SurfaceMesh surface = plain_cut_surface(result, context.threads);
  add_nearest_crack(surface, state, times, context);

  Attribute displacement{"displacement", 3, {}};
  for (const Vec3& u : state.displacements()) {
    displacement.values.insert(displacement.values.end(), u.data(), u.data() + 3);
  }
  set_attribute(surface.vertex_attributes, std::move(displacement));
  const std::vector<std::int32_t>& fragment = state.fragments.face;
  set_attribute(surface.face_attributes, {"fragment", 1, {fragment.begin(), fragment.end()}});
  const std::vector<std::int32_t>& source = surface.source_faces;
  set_attribute(surface.face_attributes, {"source_face", 1, {source.begin(), source.end()}});
  return surface;
}

}  // namespace craze
