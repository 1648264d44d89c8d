#include "craze/model/sources/curvature.h"

#include <cmath>
#include <memory>
#include <mutex>
#include <string>

#include "craze/base/elementary.h"
#include "craze/base/parallel.h"
#include "craze/base/reporting_loop.h"
#include "craze/error.h"
#include "craze/mesh/tangent_frame.h"
#include "craze/model/sources/normal_cycle.h"

namespace craze {

namespace {

// The weight (1 − ρ²)² has mean ρ² = 1/4 over the disc; a plain disc has 1/2.
constexpr double support_per_radius = 1.4142135623730951;

constexpr std::size_t grain = 64;
// Faces that all walks together may meet: about a quarter of an hour on one core.
constexpr double most_work = 1e10;
// Walks taken to estimate that, evenly spread.
constexpr std::size_t probes = 16;

/// The marks of walks, each for one thread at a time: there are as many as threads.
class ScratchPool {
 public:
  template <class Body>
  void lend(const Body& body) {
    std::unique_ptr<NormalCycle::Scratch> scratch;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!free_.empty()) {
        scratch = std::move(free_.back());
        free_.pop_back();
      }
    }
    if (!scratch) scratch = std::make_unique<NormalCycle::Scratch>();
    body(*scratch);
    const std::lock_guard<std::mutex> lock(mutex_);
    free_.push_back(std::move(scratch));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<NormalCycle::Scratch>> free_;
};

/// measure(i, scratch) for all i < n, on several threads. Throws Error(request) where a few of them
/// say that all would take too long.
template <class Measure>
void measure_all(std::size_t n, const Context& context, const Measure& measure) {
  ScratchPool pool;
  const std::size_t stride = n / probes + 1;
  double met = 0, taken = 0;
  pool.lend([&](NormalCycle::Scratch& scratch) {
    for (std::size_t i = 0; i < n; i += stride) {
      measure(i, scratch);
      met += static_cast<double>(scratch.queue.size());
      ++taken;
      context.check();
    }
  });
  if (n > 0 && met / taken * static_cast<double>(n) > most_work) {
    throw Error(ErrorKind::request, "cannot measure the curvature", "stress.curvature_radius",
                "each of " + std::to_string(n) + " places would look at about " +
                    std::to_string(std::llround(met / taken)) +
                    " triangles around it, which takes hours; give a smaller radius, or a longer "
                    "mesh.edge");
  }
  reporting_loop(context, "curvature", n, grain, [&](std::size_t begin, std::size_t end) {
    pool.lend([&](NormalCycle::Scratch& scratch) {
      for (std::size_t i = begin; i < end; ++i) measure(i, scratch);
    });
  });
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
    sum += mesh.way(mesh.from(h), mesh.to(h)).norm();
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
  measure_all(n, context, [&](std::size_t i, NormalCycle::Scratch& scratch) {
    const auto f = static_cast<std::int32_t>(i);
    if (cycle.face_normal(f).isZero()) return;
    const Vec3 centroid = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
    const auto measure = cycle.measure(centroid, support, {&f, 1}, scratch);
    const Vec3 normal = measure.normal.stableNormalized();
    tensors[i] = curvature_tensor(measure, carried_frame(tangent_frame(mesh, f), normal));
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
  measure_all(n, context, [&](std::size_t i, NormalCycle::Scratch& scratch) {
    const auto v = static_cast<std::int32_t>(i);
    std::vector<std::int32_t> star;
    mesh.for_each_outgoing(v, [&](std::int32_t h) { star.push_back(TriangleMesh::face_of(h)); });
    const auto measure = cycle.measure(mesh.position(v), support, star, scratch);
    if (measure.normal.isZero()) return;
    const Mat32 frame = any_frame(measure.normal.normalized());
    curvature[i] = principal_curvature(curvature_tensor(measure, frame), frame);
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
