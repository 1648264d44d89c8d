#include "craze/model/sources/curvature.h"

#include <algorithm>
#include <cmath>

#include "craze/base/elementary.h"
#include "craze/base/parallel.h"
#include "craze/mesh/tangent_frame.h"
#include "craze/model/sources/normal_cycle.h"

namespace craze {

namespace {

// The weight (1 − ρ²)² has mean ρ² = 1/4 over the disc; a plain disc has 1/2.
constexpr double support_per_radius = 1.4142135623730951;

// Each chunk owns marks for all faces: few chunks, whatever the number of threads.
std::size_t chunk_size(std::size_t n) {
  return std::max<std::size_t>(256, n / 64 + 1);
}

// The frame carried from the plane of its own normal n to the plane of the unit normal m by the
// smallest rotation: e ↦ e − (e·m)/(1 + n·m) (n + m).
Mat32 carried_frame(const Mat32& frame, const Vec3& m) {
  const Vec3 n = frame.col(0).cross(frame.col(1));
  const double c = 1 + n.dot(m);
  if (c < 1e-3) return frame;
  Mat32 carried;
  for (int k = 0; k < 2; ++k) {
    carried.col(k) = frame.col(k) - frame.col(k).dot(m) / c * (n + m);
  }
  return carried;
}

// The measure's tensor has each edge's bend along the edge; the surface bends across it. So turn it
// by a right angle in the plane.
Sym2 curvature_tensor(const CurvatureMeasure& measure, const Mat32& frame) {
  if (measure.area <= 0) return {};
  const Sym2 along = to_frame(measure.tensor, frame);
  return (1 / measure.area) * Sym2{along.yy, along.xx, -along.xy};
}

Mat32 any_frame(const Vec3& normal) {
  Mat32 frame;
  frame.col(0) = normal.unitOrthogonal();
  frame.col(1) = normal.cross(frame.col(0));
  return frame;
}

}  // namespace

double default_curvature_radius(const TriangleMesh& mesh) {
  double sum = 0;
  std::int64_t count = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) > h) continue;
    sum += (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
    ++count;
  }
  return count == 0 ? 0 : 2 * sum / static_cast<double>(count);
}

std::vector<Sym2> face_curvature(const TriangleMesh& mesh, double radius, const Context& context) {
  const double support =
      support_per_radius * (radius > 0 ? radius : default_curvature_radius(mesh));
  const NormalCycle cycle(mesh);
  const auto n = static_cast<std::size_t>(mesh.face_count());
  std::vector<Sym2> tensors(n);
  parallel_for(context.threads, n, chunk_size(n), [&](std::size_t begin, std::size_t end) {
    NormalCycle::Scratch scratch;
    for (std::size_t i = begin; i < end; ++i) {
      const auto f = static_cast<std::int32_t>(i);
      if (cycle.face_normal(f).isZero()) continue;
      const Triangle& t = mesh.triangle(f);
      const Vec3 centroid = (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3;
      const auto measure = cycle.measure(centroid, support, {&f, 1}, scratch);
      const Vec3 normal = measure.normal.stableNormalized();
      tensors[i] = curvature_tensor(measure, carried_frame(tangent_frame(mesh, f), normal));
    }
  });
  return tensors;
}

std::vector<PrincipalCurvature> vertex_curvature(const TriangleMesh& mesh, double radius,
                                                 const Context& context) {
  const double support =
      support_per_radius * (radius > 0 ? radius : default_curvature_radius(mesh));
  const NormalCycle cycle(mesh);
  const auto n = static_cast<std::size_t>(mesh.vertex_count());
  std::vector<PrincipalCurvature> curvature(n);
  parallel_for(context.threads, n, chunk_size(n), [&](std::size_t begin, std::size_t end) {
    NormalCycle::Scratch scratch;
    std::vector<std::int32_t> star;
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<std::int32_t>(i);
      star.clear();
      mesh.for_each_outgoing(v, [&](std::int32_t h) { star.push_back(TriangleMesh::face_of(h)); });
      const auto measure = cycle.measure(mesh.position(v), support, star, scratch);
      if (measure.normal.isZero()) continue;
      const Mat32 frame = any_frame(measure.normal.normalized());
      curvature[i] = principal_curvature(curvature_tensor(measure, frame), frame);
    }
  });
  return curvature;
}

PrincipalCurvature principal_curvature(const Sym2& tensor, const Mat32& frame) {
  const double mean = 0.5 * tensor.trace(), half = 0.5 * (tensor.xx - tensor.yy);
  const double spread = elementary::hypot(half, tensor.xy);
  const double angle = 0.5 * elementary::atan2(tensor.xy, half);
  const double c = elementary::cos(angle), s = elementary::sin(angle);
  return {mean + spread, mean - spread, c * frame.col(0) + s * frame.col(1),
          -s * frame.col(0) + c * frame.col(1)};
}

std::vector<double> curvature_factors(std::span<const PrincipalCurvature> curvature,
                                      CurvatureScale scale) {
  std::vector<double> factors(curvature.size(), 1.0);
  if (scale == CurvatureScale::none || curvature.empty()) return factors;
  double sum = 0;
  for (std::size_t i = 0; i < curvature.size(); ++i) {
    const PrincipalCurvature& c = curvature[i];
    switch (scale) {
      case CurvatureScale::gaussian:
        factors[i] = std::abs(c.gaussian());
        break;
      case CurvatureScale::mean:
        factors[i] = std::abs(c.mean());
        break;
      case CurvatureScale::frobenius:
        factors[i] = c.frobenius();
        break;
      case CurvatureScale::sum_of_squares:
        factors[i] = c.sum_of_squares();
        break;
      case CurvatureScale::none:
        break;
    }
    sum += factors[i];
  }
  const double mean = sum / static_cast<double>(curvature.size());
  if (mean <= 0) return std::vector<double>(curvature.size(), 1.0);
  for (double& f : factors) f /= mean;
  return factors;
}

}  // namespace craze
