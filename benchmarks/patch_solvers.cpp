// Ways to bring a neighbourhood back into equilibrium after a crack has run on: docs/speed.md.
#include <benchmark/benchmark.h>

#include <Eigen/Cholesky>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <vector>

#include "craze/model/cutting/crack_insertion.h"
#include "craze/model/relaxation/equilibrium.h"
#include "states.h"

namespace craze {
namespace {

using Vector = Eigen::VectorXf;
using Block = Eigen::Matrix2f;

/// A plate of n × n cells in equilibrium but for the last step of a slit two screening lengths ℓ
/// long; ℓ in edges.
class CrackedPlate {
 public:
  explicit CrackedPlate(double screening)
      : sheet_(bench::plate(cells), bench::noisy_field(bench::plate(cells), 0)),
        length_(screening / cells),
        kappa_(1 / (length_ * length_)),
        stiffness_(kappa_) {
    Equilibrium equilibrium({kappa_, 1e-3 * tolerance(), length_});
    std::vector<std::int32_t> changed(mesh_.vertex_count()), moved;
    std::iota(changed.begin(), changed.end(), 0);
    const auto restore = [&] { equilibrium.restore(field_, mesh_, changed, 1, moved); };
    restore();
    std::int32_t tip = middle();
    CrackOutcome outcome;
    const double end = mesh_.position(tip).y() + 2 * length_;
    while (mesh_.position(tip).y() < end) {
      restore();
      open_crack(sheet_, tip, Vec3::UnitX(), {0.35, 1, NearVertex::slide}, labels_++, outcome);
      changed = outcome.changed_nodes;
      const auto upper = std::max_element(outcome.tips.begin(), outcome.tips.end(),
                                          [&](std::int32_t a, std::int32_t b) {
                                            return mesh_.position(a).y() < mesh_.position(b).y();
                                          });
      if (upper == outcome.tips.end()) break;
      tip = *upper;
    }
    seeds_ = changed;
    tip_ = mesh_.position(tip);
    stiffness_.assemble(mesh_, field_);
  }

  /// A twentieth of the force at which a node of strength 1 fails.
  static double tolerance() { return 0.05 * 0.87 / cells; }
  LayerState layer() const { return {mesh_, field_, stiffness_, kappa_, tolerance()}; }
  const TriangleMesh& mesh() const { return mesh_; }
  const std::vector<std::int32_t>& seeds() const { return seeds_; }
  const Vec3& tip() const { return tip_; }
  double length() const { return length_; }
  static double edge() { return 1.0 / cells; }

 private:
  static constexpr int cells = 160;

  std::int32_t middle() const {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& p : mesh_.positions()) centre += p / mesh_.vertex_count();
    std::int32_t nearest = 0;
    const auto distance = [&](std::int32_t v) { return (mesh_.position(v) - centre).norm(); };
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (distance(v) < distance(nearest)) nearest = v;
    }
    return nearest;
  }

  CrackedSheet sheet_;
  const TriangleMesh& mesh_ = sheet_.mesh();
  StressField& field_ = sheet_.field();
  double length_, kappa_;
  TangentStiffness stiffness_;
  std::vector<std::int32_t> seeds_;
  std::int32_t labels_ = 0;
  Vec3 tip_;
};

/// The system K x = r of the nodes within three screening lengths of the tip; the others stay.
struct System {
  std::vector<std::int32_t> begin, columns, nodes;
  std::vector<Block> blocks, inverse;  ///< K row by row; the inverses of its diagonal blocks
  Vector r;
  float tolerance;

  explicit System(const CrackedPlate& plate) {
    const LayerState layer = plate.layer();
    std::vector<std::int32_t> index(plate.mesh().vertex_count(), -1);
    for (std::int32_t v = 0; v < plate.mesh().vertex_count(); ++v) {
      if ((plate.mesh().position(v) - plate.tip()).norm() > 3 * plate.length()) continue;
      index[v] = static_cast<std::int32_t>(nodes.size());
      nodes.push_back(v);
    }
    r.resize(2 * static_cast<Eigen::Index>(nodes.size()));
    begin.push_back(0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const TangentStiffness::Row row = layer.stiffness.row(nodes[i]);
      for (std::int32_t k = 0; k < row.count; ++k) {
        if (index[row.columns[k]] < 0) continue;
        const Vec4f& b = row.blocks[k];
        columns.push_back(index[row.columns[k]]);
        blocks.push_back((Block() << b[0], b[1], b[2], b[3]).finished());
      }
      inverse.push_back(blocks[begin.back()].inverse());
      begin.push_back(static_cast<std::int32_t>(columns.size()));
      const PlaneBasis basis(layer.field.normals()[nodes[i]]);
      const Vec3 pull = layer.pull(nodes[i]);
      r[2 * i] = static_cast<float>(basis.a.dot(pull));
      r[2 * i + 1] = static_cast<float>(basis.b.dot(pull));
    }
    tolerance = 0.5F * static_cast<float>(layer.tolerance);
  }

  Eigen::Index size() const { return r.size(); }
  void multiply(const Vector& x, Vector& y) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Eigen::Vector2f sum = Eigen::Vector2f::Zero();
      for (std::int32_t k = begin[i]; k < begin[i + 1]; ++k) {
        sum += blocks[k] * x.segment<2>(2 * columns[k]);
      }
      y.segment<2>(2 * i) = sum;
    }
  }
  void jacobi(const Vector& v, Vector& z) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      z.segment<2>(2 * i) = inverse[i] * v.segment<2>(2 * i);
    }
  }
  bool is_solved(const Vector& residual) const {
    return residual.lpNorm<Eigen::Infinity>() <= tolerance;
  }
  Eigen::SparseMatrix<float> assembled() const {
    std::vector<Eigen::Triplet<float>> entries;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::int32_t k = begin[i]; k < begin[i + 1]; ++k) {
        for (int a = 0; a < 2; ++a) {
          for (int b = 0; b < 2; ++b) {
            entries.emplace_back(2 * i + a, 2 * columns[k] + b, blocks[k](a, b));
          }
        }
      }
    }
    Eigen::SparseMatrix<float> matrix(size(), size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
};

using Preconditioner = std::function<void(const Vector&, Vector&)>;
constexpr int most_iterations = 20'000;

int conjugate_gradients(const System& s, const Preconditioner& precondition) {
  Vector x = Vector::Zero(s.size()), r = s.r, z(s.size()), q(s.size());
  precondition(r, z);
  Vector p = z;
  float zr = z.dot(r);
  int n = 0;
  while (!s.is_solved(r) && n++ < most_iterations) {
    s.multiply(p, q);
    const float step = zr / p.dot(q);
    x += step * p;
    r -= step * q;
    precondition(r, z);
    const float next = z.dot(r);
    p = z + (next / zr) * p;
    zr = next;
  }
  benchmark::DoNotOptimize(x.data());
  return n;
}

int with_jacobi(const System& s) {
  return conjugate_gradients(s, [&](const Vector& r, Vector& z) { s.jacobi(r, z); });
}

/// (D + L) D⁻¹ (D + Lᵀ): a sweep forward, one backward.
int with_symmetric_gauss_seidel(const System& s) {
  const auto n = static_cast<std::int32_t>(s.nodes.size());
  return conjugate_gradients(s, [&](const Vector& r, Vector& z) {
    for (std::int32_t i = 0; i < n; ++i) {
      Eigen::Vector2f sum = r.segment<2>(2 * i);
      for (std::int32_t k = s.begin[i] + 1; k < s.begin[i + 1]; ++k) {
        if (s.columns[k] < i) sum -= s.blocks[k] * z.segment<2>(2 * s.columns[k]);
      }
      z.segment<2>(2 * i) = s.inverse[i] * sum;
    }
    for (std::int32_t i = n - 1; i >= 0; --i) {
      Eigen::Vector2f sum = Eigen::Vector2f::Zero();
      for (std::int32_t k = s.begin[i] + 1; k < s.begin[i + 1]; ++k) {
        if (s.columns[k] > i) sum += s.blocks[k] * z.segment<2>(2 * s.columns[k]);
      }
      z.segment<2>(2 * i) -= s.inverse[i] * sum;
    }
  });
}

/// Jacobi and, added to it, a dense solve on pieces of four by four edges, each moving as one.
int with_coarse_level(const System& s, const CrackedPlate& plate) {
  std::map<std::pair<int, int>, std::int32_t> pieces;
  std::vector<std::int32_t> piece;
  for (const std::int32_t v : s.nodes) {
    const Vec3 p = plate.mesh().position(v) / (4 * CrackedPlate::edge());
    const auto next = static_cast<std::int32_t>(pieces.size());
    piece.push_back(
        pieces
            .try_emplace({static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))},
                         next)
            .first->second);
  }
  const auto count = 2 * static_cast<Eigen::Index>(pieces.size());
  Eigen::MatrixXf coarse = Eigen::MatrixXf::Zero(count, count);
  for (std::size_t i = 0; i < s.nodes.size(); ++i) {
    for (std::int32_t k = s.begin[i]; k < s.begin[i + 1]; ++k) {
      coarse.block<2, 2>(2 * piece[i], 2 * piece[s.columns[k]]) += s.blocks[k];
    }
  }
  const Eigen::LLT<Eigen::MatrixXf> factors(coarse);
  Vector sums(count);
  return conjugate_gradients(s, [&](const Vector& r, Vector& z) {
    s.jacobi(r, z);
    sums.setZero();
    for (std::size_t i = 0; i < piece.size(); ++i) {
      sums.segment<2>(2 * piece[i]) += r.segment<2>(2 * i);
    }
    factors.solveInPlace(sums);
    for (std::size_t i = 0; i < piece.size(); ++i) {
      z.segment<2>(2 * i) += sums.segment<2>(2 * piece[i]);
    }
  });
}

int gauss_seidel(const System& s) {
  Vector x = Vector::Zero(s.size()), y(s.size());
  int n = 0;
  for (bool solved = false; !solved && n++ < most_iterations;) {
    for (std::size_t i = 0; i < s.nodes.size(); ++i) {
      Eigen::Vector2f sum = s.r.segment<2>(2 * i);
      for (std::int32_t k = s.begin[i] + 1; k < s.begin[i + 1]; ++k) {
        sum -= s.blocks[k] * x.segment<2>(2 * s.columns[k]);
      }
      x.segment<2>(2 * i) = s.inverse[i] * sum;
    }
    if (n % 8 != 0) continue;
    s.multiply(x, y);
    solved = s.is_solved(s.r - y);
  }
  return n;
}

/// Between bounds on the eigenvalues of D⁻¹K that a run of power iterations has found; finding them
/// is not timed.
int chebyshev(const System& s, float low, float high) {
  const float middle = 0.5F * (high + low), half = 0.5F * (high - low);
  Vector x = Vector::Zero(s.size()), r = s.r, z(s.size()), p(s.size()), q(s.size());
  float alpha = 0;
  int n = 0;
  while (!s.is_solved(r) && n < most_iterations) {
    s.jacobi(r, z);
    if (n == 0) {
      p = z;
      alpha = 1 / middle;
    } else {
      const float beta =
          n == 1 ? 0.5F * (half * alpha) * (half * alpha) : 0.25F * (half * alpha) * (half * alpha);
      alpha = 1 / (middle - beta / alpha);
      p = z + beta * p;
    }
    x += alpha * p;
    s.multiply(p, q);
    r -= alpha * q;
    ++n;
  }
  benchmark::DoNotOptimize(x.data());
  return n;
}

/// The largest eigenvalue of shift · I + sign · D⁻¹K.
float largest_eigenvalue(const System& s, float shift, float sign) {
  Vector x = Vector::Random(s.size()), y(s.size()), z(s.size());
  float value = 0;
  for (int i = 0; i < 3000; ++i) {
    s.multiply(x, y);
    s.jacobi(y, z);
    z = shift * x + sign * z;
    value = z.norm() / x.norm();
    x = z / z.norm();
  }
  return value;
}

int cholesky(const System& s) {
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<float>> factors(s.assembled());
  const Vector x = factors.solve(s.r);
  benchmark::DoNotOptimize(x.data());
  return 1;
}

template <class Solve>
void measure(benchmark::State& state, Solve&& solve) {
  const CrackedPlate plate(static_cast<double>(state.range(0)));
  const System system(plate);
  int iterations = 0;
  for (auto _ : state) iterations = solve(system, plate);
  state.counters["iterations"] = iterations;
  state.counters["nodes"] = static_cast<double>(system.nodes.size());
}

void jacobi_cg(benchmark::State& state) {
  measure(state, [](const System& s, const CrackedPlate&) { return with_jacobi(s); });
}
void symmetric_gauss_seidel_cg(benchmark::State& state) {
  measure(state,
          [](const System& s, const CrackedPlate&) { return with_symmetric_gauss_seidel(s); });
}
void coarse_level_cg(benchmark::State& state) {
  measure(state, [](const System& s, const CrackedPlate& p) { return with_coarse_level(s, p); });
}
void gauss_seidel_sweeps(benchmark::State& state) {
  measure(state, [](const System& s, const CrackedPlate&) { return gauss_seidel(s); });
}
void chebyshev_iteration(benchmark::State& state) {
  const CrackedPlate plate(static_cast<double>(state.range(0)));
  const System system(plate);
  const float high = 1.01F * largest_eigenvalue(system, 0, 1);
  const float low = high - largest_eigenvalue(system, high, -1);
  int iterations = 0;
  for (auto _ : state) iterations = chebyshev(system, low, high);
  state.counters["iterations"] = iterations;
  state.counters["nodes"] = static_cast<double>(system.nodes.size());
}
void sparse_cholesky(benchmark::State& state) {
  measure(state, [](const System& s, const CrackedPlate&) { return cholesky(s); });
}

/// What craze does: nodes are read from the mesh, and only those that matter.
void growing_patch(benchmark::State& state) {
  const CrackedPlate plate(static_cast<double>(state.range(0)));
  const LayerState layer = plate.layer();
  const auto vertices = static_cast<std::size_t>(plate.mesh().vertex_count());
  std::vector<std::int32_t> seed_patch(vertices, -1), mark(vertices, -1);
  for (const std::int32_t v : plate.seeds()) seed_patch[v] = 0;
  PatchSolver solver;
  for (auto _ : state) solver.solve(layer, plate.seeds(), 0, true, seed_patch, mark);
  state.counters["iterations"] = static_cast<double>(solver.answer().iterations);
  state.counters["nodes"] = static_cast<double>(solver.answer().active);
}

#define CRAZE_PATCH_BENCHMARK(name) \
  BENCHMARK(name)->ArgName("edges_per_l")->Arg(4)->Arg(8)->Unit(benchmark::kMicrosecond)
CRAZE_PATCH_BENCHMARK(growing_patch);
CRAZE_PATCH_BENCHMARK(jacobi_cg);
CRAZE_PATCH_BENCHMARK(symmetric_gauss_seidel_cg);
CRAZE_PATCH_BENCHMARK(coarse_level_cg);
CRAZE_PATCH_BENCHMARK(gauss_seidel_sweeps);
CRAZE_PATCH_BENCHMARK(chebyshev_iteration);
CRAZE_PATCH_BENCHMARK(sparse_cholesky);

}  // namespace
}  // namespace craze
