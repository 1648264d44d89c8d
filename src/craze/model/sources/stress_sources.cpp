#include "craze/model/sources/stress_sources.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "craze/base/elementary.h"
#include "craze/base/random.h"
#include "craze/error.h"
#include "craze/mesh/tangent_frame.h"
#include "craze/model/sources/correlated_noise.h"
#include "craze/model/sources/curvature.h"
#include "craze/model/sources/surface_distance.h"

namespace craze {

namespace {

constexpr std::uint64_t stress_noise_stream = 1;

// Triangles times impacts: each impact's distances are measured over the whole surface, a million
// triangles in about a second.
constexpr double most_impact_faces = 1e9;

void check_work(std::size_t impacts, std::int32_t faces) {
  if (static_cast<double>(impacts) * faces <= most_impact_faces) return;
  const auto most = static_cast<std::int64_t>(most_impact_faces / faces);
  throw Error(ErrorKind::request, "too many impacts", "impact",
              std::to_string(impacts) + " of them on " + std::to_string(faces) +
                  " triangles take hours; give at most " + std::to_string(most) +
                  ", or a longer mesh.edge");
}

double decay(double r, double radius, double falloff) {
  return r <= radius ? 1 : elementary::pow(radius / r, falloff);
}

}  // namespace

void add_impact(std::vector<Sym2>& sigma, const TriangleMesh& mesh, const Impact& impact,
                const char* where, const Context& context) {
  const PointOnSurface hit = require_surface_point(mesh, impact.point, where, context);
  const SurfaceDistance distance = surface_distance(mesh, hit, context);
  const double radial_falloff = impact.radial_falloff > 0 ? impact.radial_falloff : impact.falloff;
  const double hoop_falloff = impact.hoop_falloff > 0 ? impact.hoop_falloff : impact.falloff;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const double r = distance.face[f];
    if (!std::isfinite(r)) continue;
    const double radial = impact.radial * decay(r, impact.radius, radial_falloff);
    const double hoop = impact.hoop * decay(r, impact.radius, hoop_falloff);
    const Vec2& d = distance.direction[f];
    if (f == hit.face || d.isZero()) {
      sigma[f] += Sym2::isotropic(0.5 * (radial + hoop));
    } else {
      const double x = d.x(), y = d.y();
      sigma[f] += Sym2{radial * x * x + hoop * y * y, radial * y * y + hoop * x * x,
                       (radial - hoop) * x * y};
    }
  }
}

std::vector<Sym2> initial_stress(const TriangleMesh& mesh, const StressParameters& stress,
                                 std::span<const Impact> impacts, std::uint64_t seed,
                                 const InputFields& fields, const Context& context) {
  const std::int32_t n = mesh.face_count();
  std::vector<Sym2> sigma(n, Sym2::isotropic(stress.uniform));

  const auto& t = stress.tensor;
  const Sym3 tensor{t[0], t[1], t[2], t[3], t[4], t[5]};
  for (std::int32_t f = 0; f < n; ++f) sigma[f] += to_frame(tensor, tangent_frame(mesh, f));

  if (stress.curvature != 0) {
    const auto kappa = face_curvature(mesh, stress.curvature_radius, context);
    for (std::int32_t f = 0; f < n; ++f) sigma[f] += stress.curvature * kappa[f];
  }
  if (!stress.attribute.empty()) {
    const auto painted = tensor_per_face(mesh, fields, stress.attribute, "stress.attribute");
    for (std::int32_t f = 0; f < n; ++f) sigma[f] += to_frame(painted[f], tangent_frame(mesh, f));
  }
  check_work(impacts.size(), n);
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    context.check();
    context.report({"impacts", static_cast<double>(i) / static_cast<double>(impacts.size())});
    const std::string where = "impact " + std::to_string(i + 1);
    add_impact(sigma, mesh, impacts[i], where.c_str(), context);
  }
  if (!impacts.empty()) context.report({"impacts", 1});
  if (stress.noise > 0) {
    const Random random(seed, stress_noise_stream);
    const auto xi = face_noise(mesh, stress.noise_length, random, context);
    for (std::int32_t f = 0; f < n; ++f) {
      sigma[f] = std::max(0.0, 1 + stress.noise * xi[f]) * sigma[f];
    }
  }
  if (!stress.texture.empty()) {
    const auto grey = texture_per_face(mesh, fields, fields.stress_texture, "stress.texture");
    for (std::int32_t f = 0; f < n; ++f) sigma[f] = grey[f] * sigma[f];
  }
  for (std::int32_t f = 0; f < n; ++f) {
    if (!(mesh.area(f) > 0)) sigma[f] = {};
  }
  return sigma;
}

}  // namespace craze
